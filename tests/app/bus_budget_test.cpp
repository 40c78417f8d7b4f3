#include "firmware/app/bus_budget.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace app {
namespace {

hal::CanFrame frame_of(std::uint8_t length, bool extended) {
  hal::CanFrame frame;
  frame.length = length;
  frame.extended = extended;
  return frame;
}

// Davis et al., Controller Area Network schedulability analysis, 2007: 55 + 10 n bits for 11-bit
// identifiers and 80 + 10 n for 29-bit ones.
TEST(BusBudget, AFrameTakesAsManyBitsAsPublished) {
  for (std::uint8_t n = 0; n <= 8; ++n) {
    EXPECT_EQ(worst_bits(frame_of(n, false)), 55u + 10u * n) << +n;
    EXPECT_EQ(worst_bits(frame_of(n, true)), 80u + 10u * n) << +n;
  }
}

TEST(BusBudget, TheRegularPlanFits) {
  // Ten status, ten detail frames and a heartbeat a second.
  EXPECT_LE(20 * worst_bits(frame_of(8, false)) + worst_bits(frame_of(1, false)),
            BusBudget::kBitsPerSecond);
}

TEST(BusBudget, AnUrgentFrameFindsRoomWhereOthersDoNot) {
  BusBudget budget;
  budget.start({});
  while (budget.allows(135)) {
    budget.spend(135);
  }
  EXPECT_TRUE(budget.allows_urgent(135));
  budget.spend(135);
  EXPECT_FALSE(budget.allows_urgent(135));
}

TEST(BusBudget, InEverySpanOfTimeTheLoadIsBounded) {
  std::mt19937 random(11);
  BusBudget budget;
  hal::Time now = hal::seconds(5);
  budget.start(now);
  struct Sent {
    std::uint64_t at_us;
    std::uint64_t bits;
  };
  std::vector<Sent> sent;
  for (int step = 0; step < 3000; ++step) {
    // Pauses at first, then a node that always has something to say.
    const bool eager = step > 1'000;
    now = now +
          hal::microseconds(!eager && random() % 5 == 0 ? random() % 2'000'000 : random() % 40'000);
    budget.advance(now);
    const auto bits = static_cast<std::uint32_t>(55 + 10 * (random() % 9));
    if (eager || random() % 2 == 0 ? budget.allows_urgent(bits) : budget.allows(bits)) {
      budget.spend(bits);
      sent.push_back({now.us, bits});
    }
  }
  ASSERT_GT(sent.size(), 500u);
  for (std::size_t first = 0; first < sent.size(); ++first) {
    std::uint64_t bits = 0;
    for (std::size_t last = first; last < sent.size(); ++last) {
      bits += sent[last].bits;
      const std::uint64_t span_us = sent[last].at_us - sent[first].at_us;
      ASSERT_LE(bits * 1'000'000,
                BusBudget::kBurstBits * 1'000'000ull + BusBudget::kBitsPerSecond * span_us);
    }
  }
}

}  // namespace
}  // namespace app
