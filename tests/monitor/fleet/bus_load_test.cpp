#include "host_sim/monitor/fleet/bus_load.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

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

using Bits = std::vector<bool>;

void append(Bits& bits, std::uint32_t value, int size) {
  for (int bit = size - 1; bit >= 0; --bit) {
    bits.push_back(((value >> bit) & 1u) != 0);
  }
}

/// Start of frame to data (ISO 11898-1, 10.4.2 and 10.4.3).
Bits bits_before_crc(const SeenFrame& seen) {
  Bits bits{false};
  if (seen.frame.extended) {
    append(bits, seen.frame.id >> 18, 11);
    append(bits, 0b11, 2);
    append(bits, seen.frame.id, 18);
  } else {
    append(bits, seen.frame.id, 11);
  }
  append(bits, seen.remote_request ? 0b100 : 0b000, 3);
  append(bits, seen.frame.length, 4);
  for (std::size_t i = 0; i < seen.frame.length && !seen.remote_request; ++i) {
    append(bits, std::to_integer<std::uint32_t>(seen.frame.data[i]), 8);
  }
  return bits;
}

/// The remainder of the bits with 15 zeros behind them, by the polynomial x^15 + x^14 + x^10 + x^8
/// + x^7 + x^4 + x^3 + 1 (10.4.2.6).
std::uint32_t remainder_of(Bits bits) {
  const std::size_t size = bits.size();
  append(bits, 0, 15);
  for (std::size_t i = 0; i < size; ++i) {
    if (bits[i]) {
      for (const std::size_t power : {15u, 14u, 10u, 8u, 7u, 4u, 3u, 0u}) {
        bits[i + 15 - power] = !bits[i + 15 - power];
      }
    }
  }
  std::uint32_t remainder = 0;
  for (std::size_t i = size; i < bits.size(); ++i) {
    remainder = 2 * remainder + (bits[i] ? 1 : 0);
  }
  return remainder;
}

/// With a bit of the other kind behind each five alike, of which it may be the first of the next
/// five (10.5).
Bits stuffed(const Bits& bits) {
  Bits result;
  std::size_t alike = 0;
  const auto put = [&](bool bit) {
    alike = !result.empty() && result.back() == bit ? alike + 1 : 1;
    result.push_back(bit);
  };
  for (const bool bit : bits) {
    put(bit);
    if (alike == 5) {
      put(!bit);
    }
  }
  return result;
}

/// A frame of any kind, half of them with long runs of bits.
SeenFrame random_frame(std::mt19937& random) {
  SeenFrame seen;
  const bool runs = random() % 2 == 0;
  const auto bits_of = [&] {
    return runs ? (random() % 2 == 0 ? 0u : ~0u) << random() % 32 : random();
  };
  seen.frame.extended = random() % 2 == 0;
  seen.frame.id =
      static_cast<std::uint32_t>(bits_of()) & (seen.frame.extended ? 0x1fff'ffffu : 0x7ffu);
  seen.frame.length = static_cast<std::uint8_t>(random() % 9);
  seen.remote_request = random() % 8 == 0;
  for (std::size_t i = 0; i < seen.frame.length && !seen.remote_request; ++i) {
    seen.frame.data[i] = static_cast<std::byte>(bits_of() & 0xff);
  }
  return seen;
}

TEST(BitsOnBus, AreThoseOfTheStandardBitByBit) {
  std::mt19937 random(1);
  for (int i = 0; i < 50'000; ++i) {
    const SeenFrame seen = random_frame(random);
    Bits bits = bits_before_crc(seen);
    append(bits, remainder_of(bits), 15);
    // Delimiter, acknowledgement and its delimiter, 7 of the end of frame, 3 between frames.
    EXPECT_EQ(bits_on_bus(seen), stuffed(bits).size() + 1 + 1 + 1 + 7 + 3)
        << std::hex << seen.frame.id << ' ' << seen.frame.extended;
  }
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
