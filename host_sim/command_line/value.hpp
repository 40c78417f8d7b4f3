#pragma once

#include <string>

#include "host_sim/command_line/command.hpp"

namespace CLI {
class Option;
}

namespace host_sim::command_line {

/// The value of an option or positional, from its type and the checks on it.
Value value_of(const CLI::Option& option);

}  // namespace host_sim::command_line
