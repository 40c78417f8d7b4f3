#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <utility>

namespace firmware_test {

/// A file of the host with the members of boards::qemu_mps2::HostFile.
class HostFile {
 public:
  enum class Mode : int {
    read = O_RDONLY,
    update = O_RDWR,
    write = O_WRONLY | O_CREAT | O_TRUNC,
    replace = O_RDWR | O_CREAT | O_TRUNC
  };

  HostFile(const char* path, Mode mode) : file_(::open(path, static_cast<int>(mode), 0644)) {}
  ~HostFile() {
    if (is_open()) {
      ::close(file_);
    }
  }
  HostFile(const HostFile&) = delete;
  HostFile& operator=(const HostFile&) = delete;

  [[nodiscard]] bool is_open() const { return file_ >= 0; }
  [[nodiscard]] std::size_t read(std::span<std::byte> out) {
    std::size_t size = 0;
    while (size < out.size()) {
      const ssize_t count = ::read(file_, out.data() + size, out.size() - size);
      if (count <= 0) {
        break;
      }
      size += static_cast<std::size_t>(count);
    }
    return size;
  }
  [[nodiscard]] bool seek(std::uint32_t position) {
    return ::lseek(file_, position, SEEK_SET) == static_cast<off_t>(position);
  }
  [[nodiscard]] bool write(std::span<const std::byte> bytes) {
    return ::write(file_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }

 private:
  int file_;
};

/// The end of a serial line where the host only listens; all goes into a file. (hal::ByteStream)
class SerialFile {
 public:
  explicit SerialFile(const char* path) : file_(path, std::ios::binary) {}

  static std::size_t try_read(std::span<std::byte>) { return 0; }
  std::size_t try_write(std::span<const std::byte> in) {
    file_.write(reinterpret_cast<const char*>(in.data()), static_cast<std::streamsize>(in.size()));
    news_.append(reinterpret_cast<const char*>(in.data()), in.size());
    return in.size();
  }

  /// What has come since the last call.
  std::string news() { return std::exchange(news_, {}); }
  /// False where not all could be written.
  [[nodiscard]] bool close() {
    file_.close();
    return file_.good();
  }

 private:
  std::ofstream file_;
  std::string news_;
};

}  // namespace firmware_test
