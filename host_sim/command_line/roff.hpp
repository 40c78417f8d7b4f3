#pragma once

#include <string>

namespace host_sim::command_line {

/// Running text for roff: nothing in it is taken for a request or an escape.
std::string roff_text(const std::string& text);

/// What is typed as it stands: dashes are those of a command line.
std::string roff_literal(const std::string& text);

}  // namespace host_sim::command_line
