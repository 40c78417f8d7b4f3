#pragma once

#include <string>
#include <string_view>

namespace host_sim::command_line {

/// `text` with each of `what` replaced.
std::string replace_all(std::string text, std::string_view what, std::string_view by);

/// One word for a POSIX shell, bash or zsh, whatever is in it.
std::string shell_quoted(const std::string& text);

/// The name of a function for `name`, which may have dashes.
std::string function_name(const std::string& name);

}  // namespace host_sim::command_line
