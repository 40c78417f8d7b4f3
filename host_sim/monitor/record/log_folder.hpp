#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/linux/descriptor.hpp"

namespace host_sim::monitor {

/// How large a log may become, and how many are kept.
struct Rotation {
  std::uint64_t bytes = std::uint64_t{64} << 20;
  std::size_t keep = 16;  ///< the oldest of more are removed; at least 1
};

/// The logs of a folder, the oldest first, links left out. Empty where it cannot be read.
std::vector<std::filesystem::path> logs_in(const std::filesystem::path& folder);

/// Whether a log of logs_in() is the one that a record begins with.
bool is_first_log(const std::filesystem::path& log);

/// The whole lines of a log. What follows the last of them is still being written, or was cut off
/// with the power. @throws InputError
std::unique_ptr<hal::files::ByteSource> open_whole_lines(const std::filesystem::path& log);

/// Logs in a folder: frames-00000001.log and so on, of which the last is written. Each ends with a
/// whole line. Files with other names are left alone, and no link is followed to what it points at.
class LogFolder {
 public:
  /// Makes the folder where it is missing, and continues the last log in it: a line that was cut
  /// off by the end of a process or a machine is removed. One process at a time has the folder.
  /// @throws OutputError
  LogFolder(const std::filesystem::path& folder, const Rotation& rotation);

  /// Adds whole lines, in the next log where this one would become too large, and takes away from
  /// `lines` what was added. @throws OutputError, and then the log ends with its last whole line
  /// all the same, and what is left of `lines` can be added later
  void add(std::string_view& lines);
  /// What was added is on the disk. @throws OutputError
  void sync();

  /// What was found torn, for people; empty where nothing was.
  [[nodiscard]] const std::string& repaired() const { return repaired_; }
  [[nodiscard]] std::filesystem::path current() const { return path_of(number_); }

 private:
  [[nodiscard]] std::filesystem::path path_of(std::uint64_t number) const;
  void open_log(std::uint64_t number, int flags);
  void open_next();
  void cut_torn_line();
  void rotate();
  void remove_old();
  void put(std::string_view lines);
  [[noreturn]] void fail() const;
  [[noreturn]] static void fail(const std::filesystem::path& path);

  std::filesystem::path folder_;
  Rotation rotation_;
  hal::linux_os::Descriptor lock_;  ///< the folder itself
  hal::linux_os::Descriptor log_;
  std::uint64_t number_ = 1;
  std::uint64_t size_ = 0;
  std::string repaired_;
};

}  // namespace host_sim::monitor
