#pragma once

#include <string>
#include <vector>

#include "host_sim/command_line/command.hpp"

namespace host_sim::command_line {

/// What a manual page says beyond the command line. Roff with the macros of man(7).
struct ManualProse {
  std::string description;
  std::string after_verbs;  ///< whole sections, between the verbs and the examples
  std::string see_also;     ///< the content of that section
};

struct Release {
  std::string version;
  std::string date;  ///< year-month-day
};

/// The manual page, section 1, of a program with verbs: each with its options, and the examples
/// out of the footers, in which `examples_in_tree` is written as `examples_installed`.
std::string manual_page(const Command& program, const Release& release, const ManualProse& prose,
                        const std::string& examples_in_tree, const std::string& examples_installed);

/// Running text for roff: nothing in it is taken for a request or an escape.
std::string roff_text(const std::string& text);

/// What is typed as it stands: dashes are those of a command line.
std::string roff_literal(const std::string& text);

/// The commands of a help text: what follows `Example:`, and the indented lines after it.
std::vector<std::string> examples_of(const std::string& footer);

}  // namespace host_sim::command_line
