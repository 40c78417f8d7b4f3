// The trail on the host: argument 1 is the file to write, argument 2 the recording.

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <span>

#include "tests/target/trail/trail.hpp"

namespace {

class Files {
 public:
  Files(const char* trail, const char* recording)
      : trail_(trail, std::ios::binary), recording_(recording, std::ios::binary) {}

  void write(const char* text) { trail_ << text; }

  std::size_t read(std::span<std::int32_t> out) {
    std::size_t count = 0;
    std::array<unsigned char, 4> b{};
    while (count < out.size() && recording_.read(reinterpret_cast<char*>(b.data()), b.size())) {
      out[count++] = static_cast<std::int32_t>(
          b[0] | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[3]} << 24);
    }
    return count;
  }

  /// False where a file could not be opened, or where not all could be written.
  [[nodiscard]] bool good() { return recording_.is_open() && trail_.flush().good(); }

 private:
  std::ofstream trail_;
  std::ifstream recording_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: trail OUT RECORDING\n";
    return 2;
  }
  Files files(argv[1], argv[2]);
  if (files.good()) {
    target::Trail(files).write();
  }
  return files.good() ? 0 : 1;
}
