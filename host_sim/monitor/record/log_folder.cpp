#include "host_sim/monitor/record/log_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"

namespace host_sim::monitor {

using hal::files::OutputError;
using hal::files::reason_of;

namespace {

using hal::linux_os::Descriptor;

constexpr std::string_view kBegin = "frames-";
constexpr std::string_view kEnd = ".log";
/// No record gets so far; a name beyond it is none of ours.
constexpr std::uint64_t kLastNumber = 999'999'999'999;

std::string name_of_log(std::uint64_t number) {
  return fmt::format("{}{:08}{}", kBegin, number, kEnd);
}

/// The number of a log of this name; none where a LogFolder does not give such a name.
std::optional<std::uint64_t> number_of(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) {
    return std::nullopt;
  }
  std::uint64_t number = 0;
  const auto [stop, error] =
      std::from_chars(name.data() + kBegin.size(), name.data() + name.size(), number);
  const bool ours = error == std::errc() && number <= kLastNumber && name == name_of_log(number);
  return ours ? std::optional(number) : std::nullopt;
}

/// The numbers of the logs of a folder, the lowest first. @throws std::filesystem::filesystem_error
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

std::vector<std::uint64_t> numbers_to_write_in(const std::filesystem::path& folder) {
  try {
    return numbers_in(folder);
  } catch (const std::filesystem::filesystem_error& error) {
    throw OutputError(folder.string(), error.code().message());
  }
}

}  // namespace

bool is_first_log(const std::filesystem::path& log) {
  return number_of(log) == 1;
}

std::vector<std::filesystem::path> logs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> logs;
  try {
    for (const std::uint64_t number : numbers_in(folder)) {
      std::filesystem::path log = folder / name_of_log(number);
      if (std::filesystem::symlink_status(log).type() == std::filesystem::file_type::regular) {
        logs.push_back(std::move(log));
      }
    }
  } catch (const std::filesystem::filesystem_error&) {
    logs.clear();
  }
  return logs;
}

namespace {

/// Holds back what follows the last end of a line, for ever where no other end comes.
class WholeLines final : public hal::files::ByteSource {
 public:
  explicit WholeLines(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}

  std::size_t read(std::span<char> buffer) override {
    constexpr std::size_t kPiece = std::size_t{64} << 10;
    while (whole_ == 0 && held_.size() <= hal::files::LineBuffer::kLineLimit) {
      const std::size_t before = held_.size();
      held_.resize(before + kPiece);
      const std::size_t count = source_->read(std::span(held_).subspan(before));
      held_.resize(before + count);
      if (count == 0) {
        return 0;
      }
      whole_ = held_.rfind('\n') + 1;
    }
    // A line that is too long is for the reader to refuse.
    const std::size_t count = std::min(buffer.size(), whole_ == 0 ? held_.size() : whole_);
    std::copy_n(held_.begin(), count, buffer.begin());
    held_.erase(0, count);
    whole_ -= std::min(count, whole_);
    return count;
  }

 private:
  std::unique_ptr<ByteSource> source_;
  std::string held_;
  std::size_t whole_ = 0;  ///< bytes of what is held that are whole lines
};

}  // namespace

std::unique_ptr<hal::files::ByteSource> open_whole_lines(const std::filesystem::path& log) {
  return std::make_unique<WholeLines>(hal::files::open_source(log, "a log of candump -L"));
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
    fail(folder_);
  }
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw OutputError(folder_.string(), "another process is recording into it");
  }
  const std::vector<std::uint64_t> numbers = numbers_to_write_in(folder_);
  if (numbers.empty()) {
    open_log(1, O_CREAT | O_EXCL);
    return;
  }
  number_ = numbers.back();
  if (std::filesystem::hard_link_count(current(), error) > 1 && !error) {
    open_next();  // what it is linked to stays as it is
    return;
  }
  open_log(number_, 0);
  cut_torn_line();
}

std::filesystem::path LogFolder::path_of(std::uint64_t number) const {
  return folder_ / name_of_log(number);
}

void LogFolder::fail() const {
  fail(current());
}

void LogFolder::fail(const std::filesystem::path& path) {
  throw OutputError(path.string(), reason_of(errno));
}

// The log that is open stays so until the next one is known to be good.
void LogFolder::open_log(std::uint64_t number, int flags) {
  const std::filesystem::path path = path_of(number);
  Descriptor log(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | flags, 0644));
  if (!log) {
    if (errno == ELOOP) {
      throw OutputError(path.string(), "it is a symbolic link; accepted: a file of this folder");
    }
    fail(path);
  }
  struct ::stat status {};
  if (::fstat(log.get(), &status) != 0) {
    fail(path);
  }
  if (!S_ISREG(status.st_mode) || status.st_nlink > 1) {
    throw OutputError(
        path.string(),
        "it is no regular file with this name alone; accepted: a file of this folder");
  }
  if (::fsync(lock_.get()) != 0) {
    fail(path);
  }
  log_ = std::move(log);
  number_ = number;
  size_ = static_cast<std::uint64_t>(status.st_size);
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

void LogFolder::add(std::string_view& lines) {
  constexpr std::uint64_t kPiece = std::uint64_t{64}
                                   << 10;  // what a full disk takes all or nothing
  const auto put_first = [&](std::size_t count) {
    put(lines.substr(0, count));
    lines.remove_prefix(count);
  };
  while (!lines.empty()) {
    const std::uint64_t room = rotation_.bytes - std::min(rotation_.bytes, size_);
    const auto most = static_cast<std::size_t>(std::min({kPiece, room, lines.size()}));
    const std::size_t last = most == 0 ? std::string_view::npos : lines.rfind('\n', most - 1);
    if (last != std::string_view::npos) {
      put_first(last + 1);
      continue;
    }
    const std::size_t line = lines.find('\n') + 1;
    if (line <= room || size_ == 0) {  // or it is larger than a log
      put_first(line);
    } else {
      rotate();
    }
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
  open_next();
  remove_old();
}

void LogFolder::open_next() {
  const std::vector<std::uint64_t> numbers = numbers_to_write_in(folder_);
  const std::uint64_t last = numbers.empty() ? number_ : std::max(number_, numbers.back());
  if (last == kLastNumber) {
    throw OutputError(path_of(last).string(), "no number is left for the log after it");
  }
  open_log(last + 1, O_CREAT | O_EXCL);
}

void LogFolder::remove_old() {
  const std::vector<std::uint64_t> numbers = numbers_to_write_in(folder_);
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
