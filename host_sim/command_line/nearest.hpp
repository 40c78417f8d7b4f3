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

/// The one of `known` that is nearest to `word` by letters inserted, left out, exchanged or swapped
/// with their neighbour (optimal string alignment), or that it is the beginning of; none where as
/// much as a third of the letters differs. The first of several that are as near.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

/// The first of them. @param words without the name of the program
std::optional<UnknownWord> first_unknown(const Command& program,
                                         std::span<const std::string> words);

}  // namespace host_sim::command_line
