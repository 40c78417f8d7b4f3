#include "firmware/app/rainflow_bins.hpp"

#include <gtest/gtest.h>

#include "hal/fake/random.hpp"
#include "lifemodel/estimator.hpp"
#include "wire.hpp"

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
  count.half(permille(390), permille(90), {});
  bins.begin_reading();
  for (std::uint32_t bin = 0; bin < RainflowBins::kBins; ++bin) {
    EXPECT_EQ(bins.cycles(bin), bin == 2 * 8 + 2 ? 2u : 0u) << bin;
    // range 0.3: class 2; mean 0.24: class 1
    EXPECT_EQ(bins.half_cycles(bin), bin == 2 * 8 + 1 ? 1u : 0u) << bin;
  }
}

TEST(RainflowBins, ACycleThatIsReadOverAndOverIsInItsBinOnce) {
  lifemodel::Estimator<1> estimator({paper_parameters()});
  RainflowBins bins;
  const auto read = [&] {
    bins.begin_reading();
    return estimator.reading(0, BinReadCycles{&bins, true}, BinReadCycles{&bins, false})
        .closed_cycles.raw();
  };
  // Fourteen cycles of 0.2 to 0.6, read at every sample: a range of 0.4, class 3, mean 0.4,
  // class 3.
  std::uint64_t closed = 0;
  for (int i = 0; i < 30; ++i) {
    estimator.push(0, permille(i % 2 == 0 ? 200 : 600));
    closed = read();
    EXPECT_EQ(bins.cycles(3 * 8 + 3), closed) << i;
  }
  EXPECT_EQ(closed, 14u);
  EXPECT_EQ(read(), 14u);
  EXPECT_EQ(bins.cycles(3 * 8 + 3), 14u);
}

TEST(RainflowBins, WhatIsOpenIsApartAndMovesOn) {
  lifemodel::Estimator<1> estimator({paper_parameters()});
  RainflowBins bins;
  const auto read_after = [&](std::int32_t tension) {
    estimator.push(0, permille(tension));
    bins.begin_reading();
    (void)estimator.reading(0, BinReadCycles{&bins, true}, BinReadCycles{&bins, false});
  };
  constexpr std::uint32_t kRise = 3 * 8 + 3;   // 0.2 to 0.6: range 0.4, mean 0.4
  constexpr std::uint32_t kSmall = 1 * 8 + 4;  // 0.6 to 0.41: range 0.19, mean 0.505
  constexpr std::uint32_t kLarge = 4 * 8 + 2;  // 0.6 to 0.09: range 0.51, mean 0.345
  read_after(200);
  read_after(600);  // 0.2 -> 0.6 is open
  EXPECT_EQ(bins.half_cycles(kRise), 1u);
  EXPECT_FALSE(bins.reported(kSmall));
  read_after(410);  // and 0.6 -> 0.41
  EXPECT_EQ(bins.half_cycles(kRise), 1u);
  EXPECT_EQ(bins.half_cycles(kSmall), 1u);
  EXPECT_EQ(bins.cycles(kSmall), 0u);
  read_after(600);  // which is a cycle now, and no half one any more
  EXPECT_EQ(bins.half_cycles(kRise), 1u);
  EXPECT_EQ(bins.half_cycles(kSmall), 0u);
  EXPECT_EQ(bins.cycles(kSmall), 1u);
  read_after(200);  // 0.6 -> 0.2 is open too
  EXPECT_EQ(bins.half_cycles(kRise), 2u);
  read_after(90);  // which has become 0.6 -> 0.09
  EXPECT_EQ(bins.half_cycles(kRise), 1u);
  EXPECT_EQ(bins.half_cycles(kLarge), 1u);
  read_after(-80);  // 0.6 -> -0.08: range 0.68, mean 0.26
  EXPECT_EQ(bins.half_cycles(5 * 8 + 2), 1u);
  EXPECT_EQ(bins.half_cycles(kLarge), 0u);
  EXPECT_TRUE(bins.reported(kLarge));
}

// Whenever it is read and settled, the bins are those of one count of all samples at the end.
TEST(RainflowBins, AreTheSameHoweverOftenTheyAreRead) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    hal::fake::Random random(seed);
    lifemodel::Estimator<1> often({paper_parameters()});
    lifemodel::Estimator<1> once({paper_parameters()});
    RainflowBins bins;
    RainflowBins whole;
    const auto read = [](auto& estimator, RainflowBins& into) {
      into.begin_reading();
      return estimator.reading(0, BinReadCycles{&into, true}, BinReadCycles{&into, false});
    };
    for (int i = 0; i < 400; ++i) {
      const auto sample = permille(static_cast<std::int32_t>(random.below(1'200)) - 200);
      often.push(0, sample);
      once.push(0, sample);
      once.flush(0, BinCycles{&whole});
      if (random.below(2) == 0) {
        while (often.settle([&](std::size_t) { return BinCycles{&bins}; })) {
        }
      }
      // Without one for so long its queue would be full.
      if (random.below(5) == 0 || i % 20 == 0) {
        const lifemodel::Reading reading = read(often, bins);
        std::uint64_t sum = 0;
        std::uint64_t halves = 0;
        for (std::uint32_t bin = 0; bin < RainflowBins::kBins; ++bin) {
          sum += bins.cycles(bin);
          halves += bins.half_cycles(bin);
        }
        ASSERT_EQ(sum, reading.closed_cycles.raw()) << seed << " " << i;
        ASSERT_EQ(halves, reading.open_half_cycles.raw()) << seed << " " << i;
      }
    }
    ASSERT_EQ(read(often, bins).total, read(once, whole).total);
    for (std::uint32_t bin = 0; bin < RainflowBins::kBins; ++bin) {
      ASSERT_EQ(bins.cycles(bin), whole.cycles(bin)) << seed << " " << bin;
      ASSERT_EQ(bins.half_cycles(bin), whole.half_cycles(bin)) << seed << " " << bin;
    }
  }
}

}  // namespace
}  // namespace app
