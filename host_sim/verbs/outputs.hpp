#pragma once

#include <initializer_list>
#include <optional>
#include <ostream>
#include <span>
#include <string>

#include "host_sim/io/output_file.hpp"

namespace host_sim {

/// The file at `path`, or none where the path is empty because nobody asked for it.
/// @throws OutputError
std::optional<OutputFile> open_if_asked(const std::string& path);

/// Why these outputs cannot be written together: two into one file would leave only one of them.
/// Empty where they can. Paths may be empty; `-` is standard output.
std::string conflict_of(std::span<const std::string> paths);

/// Puts the files in place that were asked for, when all of them are whole.
/// @throws OutputError
void commit_all(std::initializer_list<std::optional<OutputFile>*> files);

/// Where a summary for people goes: standard output, or standard error where one of the outputs
/// takes standard output.
std::ostream& summary_stream(std::span<const std::string> paths);

}  // namespace host_sim
