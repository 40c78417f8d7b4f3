#pragma once

#include <string>

#include "host_sim/command_line/command.hpp"

namespace host_sim::command_line {

// Scripts that teach a shell the command line of a program: verbs, options, words of a choice (also
// between commas), files, folders and CAN interfaces. They name nothing but what `program` has.

/// For bash 4.4 or later; needs no bash-completion.
std::string bash_completion(const Command& program);

/// For zsh 5, in a file that the program's name, with _ before it, is given.
std::string zsh_completion(const Command& program);

/// For fish 3.
std::string fish_completion(const Command& program);

}  // namespace host_sim::command_line
