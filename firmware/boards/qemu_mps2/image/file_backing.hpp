#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace firmware::qemu_mps2 {

/// Keeps a MemoryFlash in a file, each change at once, so that the end of the emulator is a power
/// cut. Without a file it keeps nothing. (hal::qemu_mps2::Backing)
template <class File>
class FileBacking {
 public:
  /// Opens the file, or makes it; gives what is wrong in words, null where nothing is. A file of
  /// another size than `bytes` is left as it is.
  const char* open(const char* path, std::uint32_t bytes) {
    file_.emplace(path, File::Mode::update);
    if (!file_->is_open()) {
      file_.emplace(path, File::Mode::replace);
      if (!file_->is_open()) {
        file_.reset();
        return "cannot be opened or made";
      }
      return fill(bytes) ? nullptr : "cannot be written";
    }
    if (count() != bytes) {
      file_.reset();
      return "has another size than the flash; accepted: 40960 bytes, or no file";
    }
    return nullptr;
  }

  bool load(std::span<std::byte> out) {
    return file_ && file_->seek(0) && file_->read(out) == out.size();
  }
  bool keep(std::uint32_t address, std::span<const std::byte> in) {
    return !file_ || (file_->seek(address) && file_->write(in));
  }

 private:
  using Chunk = std::array<std::byte, 1'024>;

  bool fill(std::uint32_t bytes) {
    Chunk erased;
    erased.fill(std::byte{0xff});
    for (std::uint32_t left = bytes; left > 0;) {
      const auto size = std::min<std::uint32_t>(left, erased.size());
      if (!file_->write(std::span(erased).first(size))) {
        return false;
      }
      left -= size;
    }
    return true;
  }

  std::uint32_t count() {
    Chunk chunk;
    std::uint32_t sum = 0;
    for (std::size_t size = chunk.size(); size == chunk.size();) {
      size = file_->read(chunk);
      sum += static_cast<std::uint32_t>(size);
    }
    return sum;
  }

  std::optional<File> file_;
};

}  // namespace firmware::qemu_mps2
