#pragma once

#include <cstddef>
#include <fstream>
#include <span>
#include <string>
#include <utility>

namespace firmware_test {

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
