// The painted stack against functions whose use of it is known by hand.

#include <cstdint>

#include "firmware/boards/qemu_mps2/measurement.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"

namespace board = boards::qemu_mps2;

// pushes.S
extern "C" void push_nothing(std::uint32_t);
extern "C" void push_words(std::uint32_t count);

namespace {

int failures = 0;

void expect(const char* what, std::uint32_t expected, std::uint32_t measured) {
  if (measured != expected) {
    ++failures;
    boards::qemu_mps2::Text<120> line;
    line << what << ": expected " << expected << ", measured " << measured << "\n";
    board::write(line.c_str());
  }
}

}  // namespace

int main() {
  expect("nothing", 0, board::stack_bytes({push_nothing, 0u}));
  for (const std::uint32_t words : {1u, 2u, 63u, 1000u, 10'000u}) {
    expect("words", 4 * words, board::stack_bytes({push_words, words}));
  }
  expect("one word after many", 4, board::stack_bytes({push_words, 1u}));
  return failures == 0 ? 0 : 1;
}
