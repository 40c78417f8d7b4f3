#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "hal/files/output_file.hpp"

namespace host_sim {

/// What the command line says of files and folders, and the option that says it. A path that is
/// empty was not asked for.
struct NamedPath {
  std::string option;
  std::filesystem::path path;
};

/// All that a run of a verb reads and writes.
struct VerbFiles {
  std::vector<NamedPath> reads;   ///< files; `-` is standard input
  std::vector<NamedPath> writes;  ///< files; `-` is standard output
  std::vector<NamedPath> fills;   ///< folders that are made, replaced or added to
};

/// To be called before anything is read: no output takes the place of what is read, of another
/// output, or of what lies in a folder that is written. Files are distinguished by what they are,
/// not by their names. The summary for people on standard output is an output as well.
/// @throws InputError for what is read, CLI::ValidationError for two outputs
void check_files(const std::string& verb, const VerbFiles& files);

/// Names all these paths by one option.
std::vector<NamedPath> named(const std::string& option,
                             std::span<const std::filesystem::path> paths);

/// The file at `path`, or none where the path is empty because nobody asked for it.
/// @throws OutputError
std::optional<hal::files::OutputFile> open_if_asked(const std::string& path);

/// Puts the files in place that were asked for, when all of them are whole.
/// @throws OutputError
void commit_all(std::initializer_list<std::optional<hal::files::OutputFile>*> files);

/// Where a summary for people goes: standard output, or standard error where one of the outputs
/// takes standard output.
std::ostream& summary_stream(std::span<const std::string> paths);

/// A path as a shell takes it and a terminal can show it.
std::string shell_word(const std::string& path);

/// The last line of a summary: what to do with what was found.
void write_next(std::ostream& out, const std::string& step);

}  // namespace host_sim
