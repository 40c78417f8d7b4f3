// The instruction counter against blocks whose length is known by hand.

#include <cstdint>

#include "firmware/boards/qemu_mps2/measurement.hpp"
#include "firmware/boards/qemu_mps2/semihosting.hpp"
#include "firmware/boards/qemu_mps2/text.hpp"

namespace board = boards::qemu_mps2;

// nops.S
extern "C" void run_nops(std::uint32_t count);
extern "C" void run_loop(std::uint32_t rounds);

namespace {

int failures = 0;

void expect(const char* what, std::uint32_t n, std::uint32_t expected, std::uint32_t counted) {
  if (counted != expected) {
    ++failures;
    boards::qemu_mps2::Text<120> line;
    line << what << "(" << n << "): expected " << expected << ", counted " << counted << "\n";
    board::write(line.c_str());
  }
}

}  // namespace

int main() {
  const board::InstructionCounter counter;
  for (std::uint32_t n = 0; n <= 1000; ++n) {
    // The branch to the function, four to reach the nops, the return.
    expect("nops", n, n + 6, counter.count({run_nops, n}));
  }
  // The branch to the function, two a round, the return.
  expect("loop", 5'000'000, 10'000'002, counter.count({run_loop, 5'000'000}));
  expect("loop", 5'300'000, board::InstructionCounter::kTooLong,
         counter.count({run_loop, 5'300'000}));
  expect("loop after a count that was too long", 1, 4, counter.count({run_loop, 1}));
  return failures == 0 ? 0 : 1;
}
