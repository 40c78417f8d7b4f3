#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hal::files {

/// A file that could not be written; what() is one line: `path: cannot be written: reason`.
class OutputError : public std::runtime_error {
 public:
  OutputError(std::string_view path, std::string_view reason);

  const std::string& path() const noexcept { return path_; }
  const std::string& reason() const noexcept { return reason_; }

 private:
  std::string path_;
  std::string reason_;
};

/// The name under which `path` is written before it is whole: `path.partial-<pid>` in the same
/// folder, its end cut off where that is too long a name.
std::filesystem::path partial_of(const std::filesystem::path& path);

/// What was renamed to `path` has its name after a power cut too. @throws OutputError
void sync_folder_of(const std::filesystem::path& path);

/// A file that appears whole or not at all. It is written to partial_of(path); commit() renames it,
/// and without commit() it is removed and an earlier file of the name stays as it was. `-` is
/// standard output; what is not a regular file (a pipe, a device) is written directly.
class OutputFile {
 public:
  /// Throws OutputError if `path` cannot be written.
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;
  ~OutputFile();

  /// Throws OutputError, as does writing through stream(), at the latest in commit().
  void write(std::string_view text);

  /// The same file as a stream, valid as long as this object.
  std::ostream& stream() noexcept;

  /// Puts the file in place, on disk. Nothing may be written afterwards.
  void commit();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// A file of this text, whole or not at all. Throws OutputError.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace hal::files
