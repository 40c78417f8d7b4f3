#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/types.h>
#include <unistd.h>

#include <concepts>
#include <cstddef>
#include <cstdio>

namespace hal::linux_os {

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

}  // namespace hal::linux_os
