#pragma once

namespace host_sim::command_line {

// Names of types that say what a value is, in the help and to a shell.
inline constexpr const char* kFile = "FILE";
inline constexpr const char* kFolder = "FOLDER";
inline constexpr const char* kInterface = "INTERFACE";

}  // namespace host_sim::command_line
