#pragma once

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hal/linux/file_calls.hpp"

namespace hal::linux_os {

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

}  // namespace hal::linux_os
