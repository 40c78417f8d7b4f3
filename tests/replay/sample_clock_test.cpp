#include "host_sim/replay/sample_clock.hpp"

#include <gtest/gtest.h>

namespace host_sim {
namespace {

TEST(SampleClock, FindsWhatIsMissing) {
  SampleClock clock(0.01);
  EXPECT_EQ(clock.missing_before(5.00), 0u);
  EXPECT_EQ(clock.missing_before(5.01), 0u);
  EXPECT_EQ(clock.missing_before(5.0249), 0u) << "jitter of half a period is no gap";
  EXPECT_EQ(clock.missing_before(5.0449), 1u);
  EXPECT_EQ(clock.missing_before(5.1449), 9u);
  EXPECT_EQ(clock.missing_before(5.1549), 0u);
  EXPECT_EQ(clock.samples(), 6u);
  EXPECT_NEAR(clock.duration_s(), 0.1549, 1e-12);
  EXPECT_FALSE(clock.other_rate());
}

TEST(SampleClock, KnowsAnotherRateFromGaps) {
  SampleClock clock(0.001);
  for (int i = 0; i < 100; ++i) {
    clock.missing_before(0.01 * i);
  }
  EXPECT_TRUE(clock.other_rate());
  EXPECT_NEAR(clock.rate_Hz(), 100, 1e-9);
}

TEST(SampleClock, AHugeGapDoesNotOverflow) {
  SampleClock clock(1e-5);
  clock.missing_before(0);
  EXPECT_EQ(clock.missing_before(1e9), 4'000'000'000u);
}

}  // namespace
}  // namespace host_sim
