// The trail on the board: argument 1 is the file to write, argument 2 the recording, both of the
// host.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "tests/target/trail/trail.hpp"

namespace {

using boards::qemu_mps2::HostFile;

class Files {
 public:
  Files(const char* trail, const char* recording)
      : trail_(trail, HostFile::Mode::write),
        recording_(recording, HostFile::Mode::read),
        good_(trail_.is_open() && recording_.is_open()) {}

  void write(const char* text) {
    const std::span<const char> bytes(text, std::string_view(text).size());
    good_ = trail_.write(std::as_bytes(bytes)) && good_;
  }

  std::size_t read(std::span<std::int32_t> out) {
    static_assert(std::endian::native == std::endian::little);
    return recording_.read(std::as_writable_bytes(out)) / sizeof(std::int32_t);
  }

  [[nodiscard]] bool good() const { return good_; }

 private:
  HostFile trail_;
  HostFile recording_;
  bool good_;
};

}  // namespace

int main() {
  const boards::qemu_mps2::Arguments arguments;
  if (arguments.count() != 3) {
    return 2;
  }
  Files files(arguments[1], arguments[2]);
  if (files.good()) {
    target::Trail(files).write();
  }
  return files.good() ? 0 : 1;
}
