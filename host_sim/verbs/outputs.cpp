#include "host_sim/verbs/outputs.hpp"

#include <fmt/ostream.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <system_error>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/command_line/quote.hpp"

namespace host_sim {

using hal::files::in_quotes;
using hal::files::InputError;
using hal::files::OutputFile;
using hal::files::printable;

namespace {

namespace fs = std::filesystem;

constexpr const char* kSummary = "the summary";

enum class FileKind { regular, folder, stream, nothing };

/// What stands at a path, or would: an inode, or a name in a folder that is one.
struct FileIdentity {
  FileKind kind;
  dev_t device;
  ino_t inode;
  std::string name;  ///< only of nothing

  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

FileIdentity place_in(const struct stat& status) {
  const auto kind = S_ISREG(status.st_mode)   ? FileKind::regular
                    : S_ISDIR(status.st_mode) ? FileKind::folder
                                              : FileKind::stream;
  return {kind, status.st_dev, status.st_ino, {}};
}

/// None where not even its folder is there.
std::optional<FileIdentity> place_of(const fs::path& path, int standard_descriptor) {
  struct stat status {};
  if (path == "-") {
    return ::fstat(standard_descriptor, &status) == 0 ? std::optional(place_in(status))
                                                      : std::nullopt;
  }
  if (::stat(path.c_str(), &status) == 0) {
    return place_in(status);
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (::stat(folder.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return FileIdentity{FileKind::nothing, status.st_dev, status.st_ino, path.filename().string()};
}

bool is_null_device(const fs::path& path) {
  struct stat status {};
  return path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISCHR(status.st_mode) &&
         status.st_rdev == makedev(1, 3);
}

/// A file and its place. Streams hold nothing that could be lost, but take one output alone.
struct Placed {
  NamedPath named;
  std::optional<FileIdentity> place;

  [[nodiscard]] bool is_same(const Placed& other) const { return place && place == other.place; }
  [[nodiscard]] bool keeps() const { return place && place->kind != FileKind::stream; }
};

std::vector<Placed> placed(const std::vector<NamedPath>& files, int standard_descriptor) {
  std::vector<Placed> all;
  for (const NamedPath& named : files) {
    if (!named.path.empty()) {
      all.push_back({named, place_of(named.path, standard_descriptor)});
    }
  }
  return all;
}

bool lies_in(const fs::path& path, const std::optional<FileIdentity>& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  const fs::path real = error ? fs::path() : fs::weakly_canonical(absolute, error);
  if (error || !folder || path == "-") {
    return false;
  }
  for (fs::path at = real; at != at.root_path(); at = at.parent_path()) {
    if (place_of(at, -1) == folder) {
      return true;
    }
  }
  return false;
}

/// `/a/b/` as `/a/b`.
fs::path without_end_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

/// Of an output.
std::string name_of(const fs::path& path) {
  return path == "-" ? "standard output" : printable(path.string());
}

[[noreturn]] void refuse_overwriting(const NamedPath& written, const std::string& what) {
  throw InputError(name_of(written.path), 0, 0, what, "an output with a name of its own");
}

std::string shown(const fs::path& path) {
  return path == "-" ? "standard input" : in_quotes(path.string());
}

void check_reads(const Placed& output, const std::vector<Placed>& reads) {
  for (const Placed& read : reads) {
    if (output.keeps() && output.is_same(read)) {
      refuse_overwriting(output.named,
                         fmt::format("{} would overwrite {}, which {} reads", output.named.option,
                                     shown(read.named.path), read.named.option));
    }
  }
}

void check_folder(const std::string& verb, const NamedPath& folder,
                  const std::vector<Placed>& reads, const std::vector<Placed>& writes) {
  const std::optional<FileIdentity> place = place_of(without_end_slash(folder.path), -1);
  for (const Placed& read : reads) {
    if (lies_in(read.named.path, place)) {
      refuse_overwriting(folder, fmt::format("{} would overwrite {}, which {} reads", folder.option,
                                             shown(read.named.path), read.named.option));
    }
  }
  for (const Placed& written : writes) {
    if (lies_in(written.named.path, place)) {
      throw CLI::ValidationError(
          verb, fmt::format("{} {} would lie in the folder of {}", written.named.option,
                            shown(written.named.path), folder.option));
    }
  }
}

void check_two_outputs(const std::string& verb, const std::vector<Placed>& writes) {
  for (auto one = writes.begin(); one != writes.end(); ++one) {
    const auto other = std::find_if(one + 1, writes.end(), [&](const Placed& later) {
      const bool whole = later.named.option != kSummary || later.keeps();
      return whole && one->is_same(later) && !is_null_device(one->named.path);
    });
    if (other != writes.end()) {
      throw CLI::ValidationError(
          verb, fmt::format("two outputs go to '{}': {} and {}", name_of(one->named.path),
                            one->named.option, other->named.option));
    }
  }
}

}  // namespace

void check_files(const std::string& verb, const VerbFiles& files) {
  std::vector<NamedPath> outputs = files.writes;
  if (std::ranges::find(outputs, fs::path("-"), &NamedPath::path) == outputs.end()) {
    outputs.push_back({kSummary, "-"});
  }
  const std::vector<Placed> reads = placed(files.reads, STDIN_FILENO);
  const std::vector<Placed> writes = placed(outputs, STDOUT_FILENO);
  for (const Placed& output : writes) {
    check_reads(output, reads);
  }
  for (const NamedPath& folder : files.fills) {
    if (!folder.path.empty()) {
      check_folder(verb, folder, reads, writes);
    }
  }
  check_two_outputs(verb, writes);
}

std::vector<NamedPath> named(const std::string& option, std::span<const fs::path> paths) {
  std::vector<NamedPath> all;
  for (const fs::path& path : paths) {
    all.push_back({option, path});
  }
  return all;
}

std::optional<OutputFile> open_if_asked(const std::string& path) {
  return path.empty() ? std::nullopt : std::optional<OutputFile>(std::in_place, path);
}

void commit_all(std::initializer_list<std::optional<OutputFile>*> files) {
  for (auto* file : files) {
    if (*file) {
      (*file)->commit();
    }
  }
}

std::ostream& summary_stream(std::span<const std::string> paths) {
  return std::find(paths.begin(), paths.end(), "-") != paths.end() ? std::cerr : std::cout;
}

std::string shell_word(const std::string& path) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:@%";
  const bool plain = !path.empty() && path.find_first_not_of(kPlain) == std::string::npos;
  return plain ? path : command_line::shell_quoted(printable(path));
}

void write_next(std::ostream& out, const std::string& step) {
  fmt::print(out, "  next          {}\n", step);
}

}  // namespace host_sim
