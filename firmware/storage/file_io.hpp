#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace storage {

/// What is wrong with a file: where, what, and what is accepted.
struct FileError {
  std::string path;
  std::string what;
};

/// One line.
inline std::string to_string(const FileError& error) {
  return error.path + ": " + error.what;
}

/// The system calls that a FileStore makes, each as in POSIX: -1 and errno where it fails. open()
/// always closes on exec, and creates with mode 0644.
template <class T>
concept FileCalls = requires(T& calls, const char* path, int fd, void* out, const void* in,
                             std::size_t size, off_t at) {
  { calls.open(path, 0) } -> std::same_as<int>;
  { calls.close(fd) } -> std::same_as<int>;
  { calls.read(fd, out, size) } -> std::same_as<ssize_t>;
  { calls.write(fd, in, size, at) } -> std::same_as<ssize_t>;
  { calls.fsync(fd) } -> std::same_as<int>;
  { calls.rename(path, path) } -> std::same_as<int>;
  { calls.lock(fd) } -> std::same_as<int>;
};

/// The calls themselves.
struct PosixFileCalls {
  static int open(const char* path, int flags) { return ::open(path, flags | O_CLOEXEC, 0644); }
  static int close(int fd) { return ::close(fd); }
  static ssize_t read(int fd, void* out, std::size_t size) { return ::read(fd, out, size); }
  static ssize_t write(int fd, const void* in, std::size_t size, off_t at) {
    return ::pwrite(fd, in, size, at);
  }
  static int fsync(int fd) { return ::fsync(fd); }
  static int rename(const char* from, const char* to) { return ::rename(from, to); }
  static int lock(int fd) { return ::flock(fd, LOCK_EX | LOCK_NB); }
};

/// The errno of a call that failed, 0 where it did not.
using Errno = int;

/// An open file, closed at the end.
template <FileCalls Calls>
class FileHandle {
 public:
  FileHandle() = default;
  FileHandle(Calls calls, const std::string& path, int flags)
      : calls_(calls), fd_(calls_.open(path.c_str(), flags)), error_(fd_ < 0 ? errno : 0) {}
  FileHandle(FileHandle&& other) noexcept
      : calls_(other.calls_), fd_(std::exchange(other.fd_, -1)), error_(other.error_) {}
  FileHandle& operator=(FileHandle&& other) noexcept {
    std::swap(calls_, other.calls_);
    std::swap(fd_, other.fd_);
    std::swap(error_, other.error_);
    return *this;
  }
  ~FileHandle() { (void)close(); }

  [[nodiscard]] int get() const { return fd_; }
  /// Why it is not open.
  [[nodiscard]] Errno error() const { return error_; }
  Errno close() {
    const int fd = std::exchange(fd_, -1);
    return fd < 0 || calls_.close(fd) == 0 ? 0 : errno;
  }

 private:
  Calls calls_{};
  int fd_ = -1;
  Errno error_ = 0;
};

template <FileCalls Calls>
Errno write_all(Calls& calls, int fd, std::span<const std::byte> bytes, off_t at) {
  while (!bytes.empty()) {
    const ssize_t count = calls.write(fd, bytes.data(), bytes.size(), at);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      return count == 0 ? EIO : errno;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    at += count;
  }
  return 0;
}

/// The bytes of a file from where it stands, the first `most` of them.
template <FileCalls Calls>
std::variant<std::vector<std::byte>, Errno> read_up_to(Calls& calls, int fd, std::size_t most) {
  std::vector<std::byte> bytes;
  std::array<std::byte, 4096> part;
  for (;;) {
    const std::size_t wanted = std::min(part.size(), most - bytes.size());
    const ssize_t count = wanted == 0 ? 0 : calls.read(fd, part.data(), wanted);
    if (count == 0) {
      return bytes;
    }
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      return errno;
    }
    bytes.insert(bytes.end(), part.begin(), part.begin() + count);
  }
}

}  // namespace storage
