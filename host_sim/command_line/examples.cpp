#include "host_sim/command_line/examples.hpp"

#include <sstream>
#include <string_view>

namespace host_sim::command_line {

std::vector<std::string> examples_of(const std::string& footer) {
  constexpr std::string_view kMark = "Example: ";
  const std::string indent(kMark.size(), ' ');
  std::vector<std::string> examples;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const bool first = line.rfind(kMark, 0) == 0;
    if (first || (!examples.empty() && line.rfind(indent, 0) == 0)) {
      examples.push_back(line.substr(kMark.size()));
    }
  }
  return examples;
}

}  // namespace host_sim::command_line
