#include "host_sim/monitor/fleet/bus_load.hpp"

#include <gtest/gtest.h>

#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor {
namespace {

using test::kMs;

SeenFrame load_frame(std::uint32_t id, bool extended, std::initializer_list<int> data) {
  SeenFrame seen;
  seen.frame.id = id;
  seen.frame.extended = extended;
  for (const int byte : data) {
    seen.frame.data[seen.frame.length++] = static_cast<std::byte>(byte);
  }
  return seen;
}

// 47 bits and 8 for each byte without stuff bits (ISO 11898-1). 0x555 with 8 bytes of 0x55 has runs
// of five in its CRC at most, whose 15 bits have room for 3 stuff bits; the control field 0001000
// has none of five.
TEST(BitsOnBus, AFrameWithoutRunsHasFewStuffBits) {
  const std::uint32_t bits =
      bits_on_bus(load_frame(0x555, false, {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55}));
  EXPECT_GE(bits, 111u);
  EXPECT_LE(bits, 114u);
}

// All zeros: SOF, 11 of id, RTR, IDE, r0, the length 1000 and 64 bits of data, and the CRC of it.
// Up to the first one of the length there are 15 zeros: stuff bits after the 5th, then after 4 more
// zeros each (a stuff bit breaks the run, and is no zero): after 5, 10, 15. Then 1 and 67
// zeros: 13.
TEST(BitsOnBus, AFrameOfZerosHasAStuffBitAfterEachFiveZeros) {
  const std::uint32_t bits = bits_on_bus(load_frame(0, false, {0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_GE(bits, 111u + 3 + 13);
  EXPECT_LE(bits, 111u + 3 + 13 + 4);
}

TEST(BitsOnBus, NeverMoreThanTheWorstOfTheStandard) {
  std::uint32_t state = 1;
  for (int i = 0; i < 2'000; ++i) {
    SeenFrame seen;
    for (std::byte& byte : seen.frame.data) {
      state = state * 1'664'525 + 1'013'904'223;
      byte = static_cast<std::byte>((state >> 24) & (i % 3 == 0 ? 0x81 : 0xff));
    }
    seen.frame.length = 8;
    seen.frame.extended = i % 2 == 0;
    seen.frame.id = state & (seen.frame.extended ? 0x1fff'ffffu : 0x7ffu);
    // 47 + 64 + 24 and 67 + 64 + 29 (ISO 11898-1).
    EXPECT_LE(bits_on_bus(seen), seen.frame.extended ? 160u : 135u);
    EXPECT_GE(bits_on_bus(seen), seen.frame.extended ? 131u : 111u);
  }
}

TEST(BitsOnBus, ARemoteFrameHasNoData) {
  SeenFrame remote = load_frame(0x555, false, {1, 2, 3, 4, 5, 6, 7, 8});
  remote.remote_request = true;
  EXPECT_GE(bits_on_bus(remote), 47u);
  EXPECT_LE(bits_on_bus(remote), 47u + 8);
}

TEST(BusLoad, IsThatOfTheLastSecond) {
  BusLoad load(1e6);
  for (int i = 0; i < 20; ++i) {
    load.add(i * 100 * kMs, 1'000);
  }
  EXPECT_DOUBLE_EQ(load.percent(), 1.0);  // ten of 1,000 bits a second
  EXPECT_DOUBLE_EQ(load.frames_per_s(), 10.0);
  load.advance(2'500 * kMs);
  EXPECT_DOUBLE_EQ(load.frames_per_s(), 4.0);  // those of 1.6 .. 1.9 s
  load.advance(60'000 * kMs);
  EXPECT_DOUBLE_EQ(load.percent(), 0.0);
}

}  // namespace
}  // namespace host_sim::monitor
