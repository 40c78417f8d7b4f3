// Files of the host and the command line: argument 1 is a file to write, read back and compare.

#include <algorithm>
#include <array>
#include <cstddef>

#include "firmware/boards/qemu_mps2/semihosting.hpp"

namespace board = boards::qemu_mps2;

namespace {

constexpr std::size_t kBytes = 1000;

std::array<std::byte, kBytes> pattern() {
  std::array<std::byte, kBytes> bytes{};
  for (std::size_t i = 0; i < kBytes; ++i) {
    bytes[i] = static_cast<std::byte>(i * 7 + i / 256);
  }
  return bytes;
}

bool write_file(const char* path) {
  board::HostFile file(path, board::HostFile::Mode::write);
  return file.is_open() && file.write(pattern());
}

bool read_file(const char* path) {
  board::HostFile file(path, board::HostFile::Mode::read);
  std::array<std::byte, kBytes + 1> bytes{};
  return file.is_open() && file.read(std::span(bytes).first(kBytes - 1)) == kBytes - 1 &&
         file.read(std::span(bytes).subspan(kBytes - 1)) == 1 &&
         file.read(std::span(bytes).first(1)) == 0 &&
         std::ranges::equal(std::span(bytes).first(kBytes), pattern());
}

}  // namespace

int main() {
  const boards::qemu_mps2::Arguments arguments;
  if (arguments.count() != 2) {
    board::write("expected one argument\n");
    return 2;
  }
  if (!write_file(arguments[1])) {
    board::write("cannot write\n");
    return 3;
  }
  if (!read_file(arguments[1])) {
    board::write("read something else\n");
    return 4;
  }
  if (board::HostFile("/nonexistent/file", board::HostFile::Mode::read).is_open()) {
    board::write("opened a file that does not exist\n");
    return 5;
  }
  return 0;
}
