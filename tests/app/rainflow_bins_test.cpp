#include "firmware/app/rainflow_bins.hpp"

#include <gtest/gtest.h>

namespace app {
namespace {

using lifemodel::Tension;

/// In thousandths of the ultimate tension.
Tension permille(std::int32_t n) {
  return Tension::from_raw(static_cast<std::int32_t>(std::int64_t{n} * (1 << 29) / 1000));
}

TEST(RainflowBins, ClassesAreEighthsOfTheUltimateTension) {
  EXPECT_EQ(RainflowBins::range_class(permille(100), permille(220)), 0u);
  EXPECT_EQ(RainflowBins::range_class(permille(220), permille(100)), 0u);
  EXPECT_EQ(RainflowBins::range_class(permille(100), permille(230)), 1u);
  EXPECT_EQ(RainflowBins::range_class(permille(0), permille(990)), 7u);
  EXPECT_EQ(RainflowBins::range_class(permille(-900), permille(990)), 7u);
  EXPECT_EQ(RainflowBins::mean_class(permille(100), permille(140)), 0u);
  EXPECT_EQ(RainflowBins::mean_class(permille(120), permille(140)), 1u);
  EXPECT_EQ(RainflowBins::mean_class(permille(-400), permille(100)), 0u);
  EXPECT_EQ(RainflowBins::mean_class(permille(1500), permille(1900)), 7u);
}

TEST(RainflowBins, EachCycleIsInOneBin) {
  RainflowBins bins;
  const BinCycles count{&bins};
  count.full(permille(150), permille(410), {});  // range 0.26: class 2; mean 0.28: class 2
  count.full(permille(410), permille(150), {});
  count.half(permille(400), permille(100), {});
  for (std::uint32_t bin = 0; bin < RainflowBins::kBins; ++bin) {
    EXPECT_EQ(bins.cycles(bin), bin == 2 * 8 + 2 ? 2u : 0u) << bin;
  }
}

}  // namespace
}  // namespace app
