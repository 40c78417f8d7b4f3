#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host_sim/command_line/command.hpp"

namespace host_sim::command_line {

/// A word of a command line that should be a verb or an option and is neither.
struct UnknownWord {
  std::string word;                    ///< of an option without its value
  std::string path;                    ///< the verbs before it, with blanks between; may be empty
  std::vector<std::string> known;      ///< the verbs or the options that may stand there
  std::optional<std::string> nearest;  ///< of these

  [[nodiscard]] bool is_option() const { return word.starts_with('-'); }
};

/// The first of them. @param words without the name of the program
std::optional<UnknownWord> first_unknown(const Command& program,
                                         std::span<const std::string> words);

}  // namespace host_sim::command_line
