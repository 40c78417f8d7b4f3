#pragma once

#include <string>
#include <vector>

namespace host_sim::command_line {

/// The commands of a help text: what follows `Example:`, and the indented lines after it.
std::vector<std::string> examples_of(const std::string& footer);

}  // namespace host_sim::command_line
