#include "host_sim/command_line/quote.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace host_sim::command_line {

std::string replace_all(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string shell_quoted(const std::string& text) {
  return fmt::format("'{}'", replace_all(text, "'", R"('\'')"));
}

std::string function_name(const std::string& name) {
  std::string function = name;
  std::replace(function.begin(), function.end(), '-', '_');
  return fmt::format("_{}", function);
}

}  // namespace host_sim::command_line
