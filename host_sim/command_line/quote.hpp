#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace host_sim::command_line {

/// `text` with each of `what` replaced.
inline std::string replace_all(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// One word for a POSIX shell, bash or zsh, whatever is in it.
inline std::string shell_quoted(const std::string& text) {
  return "'" + replace_all(text, "'", R"('\'')") + "'";
}

/// The name of a function for `name`, which may have dashes.
inline std::string function_name(const std::string& name) {
  std::string function = name;
  std::replace(function.begin(), function.end(), '-', '_');
  return "_" + function;
}

}  // namespace host_sim::command_line
