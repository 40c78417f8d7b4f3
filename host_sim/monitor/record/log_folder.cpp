#include "host_sim/monitor/record/log_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <vector>

#include "host_sim/io/output_file.hpp"

namespace host_sim::monitor {
namespace {

using hal::linux_os::Descriptor;

constexpr std::string_view kBegin = "frames-";
constexpr std::string_view kEnd = ".log";

std::optional<std::uint64_t> number_of(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) {
    return std::nullopt;
  }
  std::uint64_t number = 0;
  const char* const end = name.data() + name.size() - kEnd.size();
  const auto [stop, error] = std::from_chars(name.data() + kBegin.size(), end, number);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// The numbers of the logs of a folder, the lowest first.
std::vector<std::uint64_t> numbers_in(const std::filesystem::path& folder) {
  std::vector<std::uint64_t> numbers;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (const auto number = number_of(entry.path())) {
      numbers.push_back(*number);
    }
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::string name_of_log(std::uint64_t number) {
  return fmt::format("{}{:08}{}", kBegin, number, kEnd);
}

}  // namespace

std::vector<std::filesystem::path> logs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> logs;
  try {
    for (const std::uint64_t number : numbers_in(folder)) {
      logs.push_back(folder / name_of_log(number));
    }
  } catch (const std::filesystem::filesystem_error&) {
    logs.clear();
  }
  return logs;
}

LogFolder::LogFolder(const std::filesystem::path& folder, const Rotation& rotation)
    : folder_(folder), rotation_(rotation) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    throw OutputError(folder_.string(), error.message());
  }
  lock_ = Descriptor(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!lock_) {
    throw OutputError(folder_.string(), std::strerror(errno));
  }
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw OutputError(folder_.string(), "another process is recording into it");
  }
  const std::vector<std::uint64_t> numbers = numbers_in(folder_);
  open_log(numbers.empty() ? 1 : numbers.back());
  cut_torn_line();
}

std::filesystem::path LogFolder::path_of(std::uint64_t number) const {
  return folder_ / name_of_log(number);
}

void LogFolder::fail() const {
  throw OutputError(current().string(), std::strerror(errno));
}

void LogFolder::open_log(std::uint64_t number) {
  number_ = number;
  log_ = Descriptor(::open(current().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!log_) {
    fail();
  }
  const off_t end = ::lseek(log_.get(), 0, SEEK_END);
  if (end < 0 || ::fsync(lock_.get()) != 0) {
    fail();
  }
  size_ = static_cast<std::uint64_t>(end);
}

void LogFolder::cut_torn_line() {
  std::array<char, 4096> bytes{};
  std::uint64_t whole = size_;
  while (whole > 0) {
    const std::uint64_t begin = whole - std::min<std::uint64_t>(whole, bytes.size());
    const ssize_t count =
        ::pread(log_.get(), bytes.data(), whole - begin, static_cast<off_t>(begin));
    if (count != static_cast<ssize_t>(whole - begin)) {
      fail();
    }
    const std::string_view text(bytes.data(), static_cast<std::size_t>(count));
    const std::size_t last = text.rfind('\n');
    whole = last == std::string_view::npos ? begin : begin + last + 1;
    if (last != std::string_view::npos) {
      break;
    }
  }
  if (whole == size_) {
    return;
  }
  repaired_ = fmt::format("{}: a torn last line of {} bytes was cut off", current().string(),
                          size_ - whole);
  if (::ftruncate(log_.get(), static_cast<off_t>(whole)) != 0) {
    fail();
  }
  size_ = whole;
  sync();
}

void LogFolder::add(std::string_view lines) {
  while (!lines.empty()) {
    const std::uint64_t room = rotation_.bytes - std::min(rotation_.bytes, size_);
    if (lines.size() <= room) {
      put(lines);
      return;
    }
    const std::size_t last =
        room == 0 ? std::string_view::npos : lines.rfind('\n', static_cast<std::size_t>(room) - 1);
    if (last == std::string_view::npos && size_ == 0) {  // a line that is larger than a log
      const std::size_t line = lines.find('\n') + 1;
      put(lines.substr(0, line));
      lines.remove_prefix(line);
      continue;
    }
    if (last != std::string_view::npos) {
      put(lines.substr(0, last + 1));
      lines.remove_prefix(last + 1);
    }
    rotate();
  }
}

void LogFolder::put(std::string_view lines) {
  std::uint64_t at = size_;
  while (!lines.empty()) {
    const ssize_t count = ::pwrite(log_.get(), lines.data(), lines.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      const int error = errno;
      (void)!::ftruncate(log_.get(), static_cast<off_t>(size_));
      errno = error;
      fail();
    }
    at += static_cast<std::uint64_t>(count);
    lines.remove_prefix(static_cast<std::size_t>(count));
  }
  size_ = at;
}

void LogFolder::rotate() {
  sync();
  open_log(number_ + 1);
  remove_old();
}

void LogFolder::remove_old() {
  const std::vector<std::uint64_t> numbers = numbers_in(folder_);
  for (std::size_t i = 0; i + std::max<std::size_t>(rotation_.keep, 1) < numbers.size(); ++i) {
    std::error_code ignored;  // one that somebody holds open goes another time
    std::filesystem::remove(path_of(numbers[i]), ignored);
  }
}

void LogFolder::sync() {
  if (::fsync(log_.get()) != 0) {
    fail();
  }
}

}  // namespace host_sim::monitor
