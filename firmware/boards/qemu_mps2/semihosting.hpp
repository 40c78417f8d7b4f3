#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// The services of the host that QEMU runs on; Arm, Semihosting for AArch32 and AArch64.
namespace boards::qemu_mps2 {

/// Ends QEMU with this exit code, 0 .. 255.
extern "C" [[noreturn]] void exit(int code);

/// Writes a zero-terminated text to the console, which is the standard error of QEMU.
void write(const char* text);

/// Copies the command line, the image's path first, and terminates it by zero. Returns its length
/// without the zero, or 0 where it does not fit.
std::size_t command_line(std::span<char> out);

/// A file of the host; closed at the end of the scope.
class HostFile {
 public:
  /// Values of the standard: modes of fopen, binary; `update` wants a file that is there, `replace`
  /// makes a new one, and both read and write.
  enum class Mode : std::uint32_t { read = 1, update = 3, write = 5, replace = 7 };

  HostFile(const char* path, Mode mode);
  ~HostFile();
  HostFile(const HostFile&) = delete;
  HostFile& operator=(const HostFile&) = delete;

  [[nodiscard]] bool is_open() const { return handle_ != kNoHandle; }
  /// Bytes that were read: fewer than asked for only at the end of the file.
  [[nodiscard]] std::size_t read(std::span<std::byte> out);
  /// The next byte that is read or written. True when it is there.
  [[nodiscard]] bool seek(std::uint32_t position);
  /// True when all bytes were written.
  [[nodiscard]] bool write(std::span<const std::byte> bytes);

 private:
  static constexpr std::uint32_t kNoHandle = 0xffffffffu;
  std::uint32_t handle_;
};

/// The command line of the program, split at spaces; the image's path is argument 0. No quoting. A
/// line that is too long gives no arguments at all.
class Arguments {
 public:
  Arguments() {
    const std::size_t size = command_line(line_);
    bool inside = false;
    for (std::size_t i = 0; i < size; ++i) {
      if (line_[i] == ' ') {
        line_[i] = '\0';
        inside = false;
      } else if (!inside && count_ < words_.size()) {
        words_[count_++] = &line_[i];
        inside = true;
      }
    }
  }
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::span<const char* const> words() const {
    return std::span(words_).first(count_);
  }
  /// @pre index < count()
  [[nodiscard]] const char* operator[](std::size_t index) const { return words_[index]; }

 private:
  std::array<char, 1024> line_{};
  std::array<const char*, 16> words_{};
  std::size_t count_ = 0;
};

}  // namespace boards::qemu_mps2
