#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <set>
#include <vector>

#include "hal/devices.hpp"

namespace hal_test {

/// What hal/entropy.hpp states. `Rig`:
///   auto& source()
///   bool break_it()   from now on the source is broken; false where that cannot be
template <class Rig>
class EntropyContract : public testing::Test {
 protected:
  Rig rig_;
};

TYPED_TEST_SUITE_P(EntropyContract);

TYPED_TEST_P(EntropyContract, FillsAllAndNothingElse) {
  for (const std::size_t size : {0u, 1u, 3u, 4u, 5u, 8u, 15u, 16u, 17u, 64u}) {
    // A byte stays 0xa5 by chance once in 256 tries, so several fills together must change each.
    std::array<bool, 64> changed{};
    for (int i = 0; i < 32; ++i) {
      std::array<std::byte, 66> memory{};
      memory.fill(std::byte{0xa5});
      ASSERT_EQ(this->rig_.source().fill(std::span(memory).subspan(1, size)), hal::Error::none);
      EXPECT_EQ(memory[0], std::byte{0xa5});
      EXPECT_EQ(memory[size + 1], std::byte{0xa5});
      for (std::size_t at = 0; at < size; ++at) {
        changed[at] = changed[at] || memory[at + 1] != std::byte{0xa5};
      }
    }
    EXPECT_EQ(std::count(changed.begin(), changed.end(), true), static_cast<long>(size));
  }
}

TYPED_TEST_P(EntropyContract, GivesANonceOnlyOnce) {
  std::set<std::vector<std::byte>> seen;
  for (int i = 0; i < 1'000; ++i) {
    std::vector<std::byte> nonce(16);
    ASSERT_EQ(this->rig_.source().fill(nonce), hal::Error::none);
    EXPECT_TRUE(seen.insert(nonce).second);
  }
}

TYPED_TEST_P(EntropyContract, HalfOfTheBitsAreSet) {
  std::vector<std::byte> bytes(8'192);
  ASSERT_EQ(this->rig_.source().fill(bytes), hal::Error::none);
  int ones = 0;
  for (const std::byte byte : bytes) {
    ones += std::popcount(static_cast<unsigned char>(byte));
  }
  // 65,536 bits: the standard deviation is 128, and this allows eight of them.
  EXPECT_NEAR(ones, 32'768, 1'024);
}

TYPED_TEST_P(EntropyContract, ABrokenSourceGivesNothingUsable) {
  if (!this->rig_.break_it()) {
    GTEST_SKIP() << "this back end cannot fail";
  }
  std::array<std::byte, 16> bytes{};
  EXPECT_EQ(this->rig_.source().fill(bytes), hal::Error::failed);
}

REGISTER_TYPED_TEST_SUITE_P(EntropyContract, FillsAllAndNothingElse, GivesANonceOnlyOnce,
                            HalfOfTheBitsAreSet, ABrokenSourceGivesNothingUsable);

}  // namespace hal_test
