#include "lifemodel/watch/wire_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "lifemodel/pack/pack.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::kUltimate_N;
using lifemodel_test::newtons;

constexpr std::uint32_t kPeriod_us = 1000;

TensionRange range_of(double range_N) {
  return distance(newtons(range_N), newtons(0));
}

Velocity velocity(double mm_s) {
  return pack::from_double<Velocity>(mm_s * 1e-3);
}

WatchLimits limits(Tension minimum, Tension broken, std::uint32_t broken_travel_um,
                   std::uint32_t slack_travel_um) {
  WatchLimits limits{};
  limits.minimum = minimum;
  limits.broken = broken;
  limits.broken_travel_um = broken_travel_um;
  limits.slack_travel_um = slack_travel_um;
  return limits;
}

/// Slack below 5 N over 4 mm, broken below 2 N over 20 mm; 2 N of hysteresis, 1 kHz.
WireWatch watch() {
  return {limits(newtons(5), newtons(2), 20'000, 4'000), range_of(2), kPeriod_us};
}

double peak_N(const WireWatch& watch) {
  return std::ldexp(watch.reading().peak, -29) * kUltimate_N;
}

/// Moves by a travel at 100 mm/s, that is 0.1 mm in each sample; negative is back.
void move(WireWatch& watch, double tension_N, double travel_mm) {
  const int samples = static_cast<int>(std::lround(std::fabs(travel_mm) * 10));
  for (int i = 0; i < samples; ++i) {
    watch.push(newtons(tension_N), velocity(travel_mm < 0 ? -100 : 100));
  }
}

void stand(WireWatch& watch, double tension_N, int samples) {
  for (int i = 0; i < samples; ++i) {
    watch.push(newtons(tension_N), {});
  }
}

using Counts = std::array<std::uint32_t, 3>;

TEST(WireWatch, ThePeakIsTheHighestTension) {
  WireWatch wire = watch();
  for (const double tension_N : {20.0, 30.0, 25.0, 29.9, 31.5, 31.0}) {
    wire.push(newtons(tension_N));
  }
  EXPECT_NEAR(peak_N(wire), 31.5, 1e-6);
  wire.push(newtons(-40));
  EXPECT_NEAR(peak_N(wire), 40, 1e-6);
  wire.push(Tension::lowest());
  EXPECT_EQ(wire.reading().peak, 0x7fffffffu);
  wire.begin();
  wire.push(Tension::from_raw(-1000));
  wire.push(Tension::from_raw(1001));
  EXPECT_EQ(wire.reading().peak, 1001u);
}

TEST(WireWatch, AWindowHasAPeakOfItsOwn) {
  WireWatch wire = watch();
  const auto window_N = [&] { return std::ldexp(wire.reading().window_peak, -29) * kUltimate_N; };
  move(wire, 100, 1);
  EXPECT_NEAR(window_N(), 100, 1e-6);
  wire.begin_window();
  EXPECT_EQ(wire.reading().window_peak, 0u);
  stand(wire, 60, 2);
  stand(wire, 70, 2);
  stand(wire, 65, 2);
  EXPECT_NEAR(window_N(), 70, 1e-6);
  EXPECT_NEAR(peak_N(wire), 100, 1e-6);
  stand(wire, 120, 2);
  EXPECT_NEAR(window_N(), 120, 1e-6);
  EXPECT_NEAR(peak_N(wire), 120, 1e-6);
  // The excursion above 50 % that began before the window is one, and the travel of a loose wire is
  // not begun anew.
  EXPECT_EQ(wire.reading().above, (Counts{2, 0, 0}));
  move(wire, 1, 15);
  wire.begin_window();
  move(wire, 1, 5.1);
  EXPECT_TRUE(wire.reading().broken);
  EXPECT_NEAR(window_N(), 1, 1e-6);
  wire.begin();
  EXPECT_EQ(wire.reading().window_peak, 0u);
}

/// 88.7, 124.18 and 159.66 N of 177.4 N.
TEST(WireWatch, AnExcursionCountsOnceUntilItHasComeBackByTheHysteresis) {
  WireWatch wire = watch();
  for (const double tension_N : {80.0, 88.6, 88.8, 87.0, 88.8, 90.0, 86.8, 88.8}) {
    wire.push(newtons(tension_N));
  }
  EXPECT_EQ(wire.reading().above, (Counts{1, 0, 0}));
  wire.push(newtons(86.6));
  EXPECT_EQ(wire.reading().above, (Counts{1, 0, 0}));
  wire.push(newtons(88.8));
  EXPECT_EQ(wire.reading().above, (Counts{2, 0, 0}));
  for (const double tension_N :
       {125.0, 123.0, 125.0, 122.0, 160.0, 158.0, 157.0, 160.0, 10.0, 177.4, 10.0}) {
    wire.push(newtons(tension_N));
  }
  EXPECT_EQ(wire.reading().above, (Counts{3, 3, 3}));
}

/// From 88.7 N back to 48.7 N, though the level above it is left at 84.18 N.
TEST(WireWatch, EachLevelComesBackByTheHysteresis) {
  WireWatch wire({}, range_of(40), kPeriod_us);
  for (const double tension_N : {130.0, 84.0, 100.0, 130.0, 48.8, 100.0, 48.6, 100.0}) {
    wire.push(newtons(tension_N));
  }
  EXPECT_EQ(wire.reading().above, (Counts{2, 2, 0}));
}

TEST(WireWatch, TheLevelItselfCounts) {
  WireWatch wire = watch();
  wire.push(Tension::from_raw((1 << 28) - 1));
  EXPECT_EQ(wire.reading().above[0], 0u);
  wire.push(Tension::from_raw(1 << 28));
  EXPECT_EQ(wire.reading().above[0], 1u);
}

TEST(WireWatch, SamplesBelowTheMinimumAreCounted) {
  WireWatch wire = watch();
  stand(wire, 10, 7);
  stand(wire, 4.9, 30);
  stand(wire, 5.1, 9);
  stand(wire, 0, 5);
  stand(wire, -4.9, 2);
  stand(wire, -5.1, 4);
  EXPECT_EQ(wire.reading().below_minimum, 37u);
  EXPECT_EQ(wire.reading().slack_events, 0u);
  EXPECT_FALSE(wire.reading().broken);
}

TEST(WireWatch, IsSlackOnceItHasMovedOverTheSlackTravel) {
  WireWatch wire = watch();
  move(wire, 30, -50);
  move(wire, 3, -3.9);
  EXPECT_FALSE(wire.reading().slack);
  move(wire, 3, -0.2);
  EXPECT_TRUE(wire.reading().slack);
  EXPECT_EQ(wire.reading().slack_events, 1u);
  move(wire, 3, 50);
  EXPECT_TRUE(wire.reading().slack);
  stand(wire, 30, 1);
  EXPECT_FALSE(wire.reading().slack);
  move(wire, 3, 3.9);
  EXPECT_EQ(wire.reading().slack_events, 1u);
  move(wire, 3, 0.2);
  EXPECT_EQ(wire.reading().slack_events, 2u);
  EXPECT_FALSE(wire.reading().broken);
}

TEST(WireWatch, ToAndFroIsNoMoreTravelThanItsEndsAreApart) {
  WireWatch wire = watch();
  stand(wire, 30, 1);
  for (int i = 0; i < 100; ++i) {
    move(wire, 1, 3.5);
    move(wire, 1, -3.5);
  }
  EXPECT_EQ(wire.reading().slack_events, 0u);
  EXPECT_FALSE(wire.reading().broken);
}

TEST(WireWatch, IsBrokenOnceItWasPulledOverTheBrokenTravelAtFrictionAlone) {
  WireWatch wire = watch();
  move(wire, 30, 100);
  move(wire, 1, 19.9);
  EXPECT_FALSE(wire.reading().broken);
  EXPECT_TRUE(wire.reading().slack);
  move(wire, 1, 0.2);
  EXPECT_TRUE(wire.reading().broken);
  EXPECT_FALSE(wire.reading().slack);
  EXPECT_EQ(wire.reading().slack_events, 1u);
  move(wire, 60, 10);
  EXPECT_TRUE(wire.reading().broken);
  move(wire, 3, 10);
  EXPECT_FALSE(wire.reading().slack);
}

TEST(WireWatch, SlackThatIsTakenUpIsNoBreak) {
  WireWatch wire = watch();
  move(wire, 30, -5);
  move(wire, 0.5, -19);
  move(wire, 0.5, 19);
  move(wire, 30, 5);
  EXPECT_FALSE(wire.reading().broken);
  // Above friction alone it is slack, however far it is pulled.
  move(wire, 2.1, 100);
  EXPECT_FALSE(wire.reading().broken);
  EXPECT_EQ(wire.reading().slack_events, 2u);
}

TEST(WireWatch, TheTensionOfFrictionAloneIsAmongThoseOfABreak) {
  WireWatch wire = watch();
  move(wire, 2, 20.1);
  EXPECT_TRUE(wire.reading().broken);
  WireWatch alone(limits({}, newtons(2), 20'000, 0), range_of(2), kPeriod_us);
  move(alone, 2, 20.1);
  EXPECT_TRUE(alone.reading().broken);
  WireWatch other = watch();
  for (int i = 0; i < 300; ++i) {
    other.push(Tension::from_raw(newtons(2).raw() + 1), velocity(100));
  }
  EXPECT_FALSE(other.reading().broken);
}

TEST(WireWatch, ReleasingAloneIsNoBreak) {
  WireWatch wire = watch();
  move(wire, 0.5, -1000);
  EXPECT_FALSE(wire.reading().broken);
  move(wire, 0.5, 20.1);
  EXPECT_TRUE(wire.reading().broken);
}

TEST(WireWatch, ATensionOfTheOtherWireOfAPairIsNoSlack) {
  WireWatch wire = watch();
  move(wire, -30, 100);
  EXPECT_EQ(wire.reading(),
            (WatchReading{.peak = wire.reading().peak, .window_peak = wire.reading().peak}));
  move(wire, -1, 20.1);
  EXPECT_TRUE(wire.reading().broken);
}

TEST(WireWatch, SlowMotionIsNone) {
  WireWatch wire = watch();
  for (int i = 0; i < 100'000; ++i) {
    wire.push(newtons(1), velocity(0.99));
    wire.push(newtons(1), velocity(-0.99));
    wire.push(newtons(1), velocity(0.99));
  }
  EXPECT_EQ(wire.reading().slack_events, 0u);
  EXPECT_FALSE(wire.reading().broken);
  for (int i = 0; i < 100'000; ++i) {
    wire.push(newtons(1), WireWatch::kStill);
  }
  EXPECT_EQ(wire.reading().slack_events, 0u);
  EXPECT_FALSE(wire.reading().broken);
  for (int i = 0; i < 20'000; ++i) {
    wire.push(newtons(1), velocity(1.01));
  }
  EXPECT_TRUE(wire.reading().broken);
}

TEST(WireWatch, AShortGapIsLeftOutAndALongOneBeginsAnew) {
  WireWatch wire = watch();
  move(wire, 1, 15);
  wire.miss(16);
  move(wire, 1, 5.1);
  EXPECT_TRUE(wire.reading().broken);

  wire = watch();
  move(wire, 1, 15);
  wire.miss(10);
  wire.miss(7);
  move(wire, 1, 19.9);
  EXPECT_FALSE(wire.reading().broken);
  wire.miss(~0u);
  wire.miss(1);
  move(wire, 1, 19.9);
  EXPECT_FALSE(wire.reading().broken);
  move(wire, 1, 0.2);
  EXPECT_TRUE(wire.reading().broken);
}

TEST(WireWatch, ANewWireBeginsWithoutBreakAndPeak) {
  WireWatch wire = watch();
  move(wire, 100, 1);
  move(wire, 1, 20.1);
  ASSERT_TRUE(wire.reading().broken);
  const WatchReading before = wire.reading();
  wire.begin();
  EXPECT_FALSE(wire.reading().broken);
  EXPECT_EQ(wire.reading().peak, 0u);
  EXPECT_EQ(wire.reading().above, before.above);
  EXPECT_EQ(wire.reading().below_minimum, before.below_minimum);
  EXPECT_EQ(wire.reading().slack_events, before.slack_events);
  stand(wire, 40, 3);
  EXPECT_NEAR(peak_N(wire), 40, 1e-6);
  move(wire, 1, 19.9);
  EXPECT_FALSE(wire.reading().broken);
  move(wire, 1, 0.2);
  EXPECT_TRUE(wire.reading().broken);
}

TEST(WireWatch, AWireUnderLoadBeginsItsOwnExcursion) {
  WireWatch wire = watch();
  stand(wire, 100, 3);
  wire.begin();
  stand(wire, 100, 3);
  EXPECT_EQ(wire.reading().above, (Counts{2, 0, 0}));
}

TEST(WireWatch, WithoutLimitsOnlyPeaksAreWatched) {
  WireWatch wire({}, range_of(2), kPeriod_us);
  move(wire, 100, 1);
  move(wire, 0, 1000);
  const WatchReading reading = wire.reading();
  EXPECT_NEAR(peak_N(wire), 100, 1e-6);
  EXPECT_EQ(reading.above, (Counts{1, 0, 0}));
  EXPECT_EQ(reading.below_minimum, 0u);
  EXPECT_EQ(reading.slack_events, 0u);
  EXPECT_FALSE(reading.broken);
}

TEST(WireWatch, ATravelOfNoneIsOff) {
  WireWatch wire(limits(newtons(5), newtons(2), 0, 0), range_of(2), kPeriod_us);
  move(wire, 0, 1000);
  EXPECT_EQ(wire.reading().below_minimum, 10'000u);
  EXPECT_EQ(wire.reading().slack_events, 0u);
  EXPECT_FALSE(wire.reading().broken);
}

TEST(WireWatch, AMinimumBelowThatOfFrictionAloneHoldsToo) {
  WireWatch wire(limits(newtons(2), newtons(5), 20'000, 4'000), range_of(2), kPeriod_us);
  move(wire, 3, 19.9);
  EXPECT_EQ(wire.reading().slack_events, 0u);
  EXPECT_EQ(wire.reading().below_minimum, 0u);
  move(wire, 3, 0.2);
  EXPECT_TRUE(wire.reading().broken);
}

TEST(WireWatch, TheEndsOfTheRangesAreOrdinaryValues) {
  WireWatch wire(limits(Tension::highest(), Tension::highest(), ~0u, ~0u), TensionRange::highest(),
                 ~0u);
  for (int i = 0; i < 100; ++i) {
    wire.push(Tension::from_raw(0), Velocity::lowest());
  }
  EXPECT_TRUE(wire.reading().slack);
  for (int i = 0; i < 100; ++i) {
    wire.push(Tension::from_raw(0), Velocity::highest());
  }
  EXPECT_TRUE(wire.reading().broken);
  wire.push(Tension::lowest());
  EXPECT_EQ(wire.reading().above, (Counts{1, 1, 1}));
}

/// The band, within which samples are passed over, changes nothing: the same as sample by sample.
TEST(WireWatch, PassesOverNothingThatCounts) {
  std::mt19937 random(7);
  std::normal_distribution<double> step_N(0, 6);
  std::normal_distribution<double> speed_mm_s(0, 100);
  for (int run = 0; run < 20; ++run) {
    WireWatch wire = watch();
    double tension_N = 50;
    double peak = 0;
    double window_peak = 0;
    std::array<bool, 3> above{};
    Counts counts{};
    std::uint32_t below = 0;
    for (int i = 0; i < 5000; ++i) {
      tension_N = std::fabs(tension_N + step_N(random));
      tension_N = tension_N > 190 ? 380 - tension_N : tension_N;
      wire.push(newtons(tension_N), velocity(speed_mm_s(random)));
      peak = std::max(peak, tension_N);
      window_peak = std::max(window_peak, tension_N);
      if (i % 500 == 499) {
        EXPECT_NEAR(std::ldexp(wire.reading().window_peak, -29) * kUltimate_N, window_peak, 1e-6);
        wire.begin_window();
        window_peak = 0;
      }
      below += tension_N < 5 ? 1 : 0;
      for (std::size_t level = 0; level < 3; ++level) {
        const double at_N = std::array{88.7, 124.18, 159.66}[level];
        if (!above[level] && tension_N >= at_N) {
          above[level] = true;
          ++counts[level];
        } else if (tension_N < at_N - 2) {
          above[level] = false;
        }
      }
    }
    ASSERT_GT(below, 0u);
    EXPECT_NEAR(peak_N(wire), peak, 1e-6);
    EXPECT_EQ(wire.reading().above, counts);
    EXPECT_EQ(wire.reading().below_minimum, below);
  }
}

/// A wire holds the sheath's end under a load that swings, and breaks at a random sample. At
/// friction alone afterwards, with noise, it is found within the stated travel of pulling, and
/// never before the break.
TEST(WireWatch, ACutWireIsFoundWithinTheStatedTravel) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> noise_N(0, 0.1);
    const double stroke_mm = 25 + 100 * uniform(random);  // from one end to the other
    const double period_s = 0.5 + 4 * uniform(random);
    const double mean_N = 15 + 60 * uniform(random);
    const double swing_N = (mean_N - 6) * uniform(random);
    const double phase = 7 * uniform(random);
    const int cut = static_cast<int>(period_s * 1000 * (1 + 3 * uniform(random)));
    WireWatch wire = watch();
    double position_mm = 0;
    double released_mm = 0;
    int found = -1;
    for (int i = 0; found < 0 && i < cut + 3 * period_s * 1000; ++i) {
      const double at = 2 * M_PI * i * 1e-3 / period_s + phase;
      const double speed_mm_s = -M_PI * stroke_mm / period_s * std::sin(at);
      const double taut_N = mean_N + swing_N * std::cos(at) * (speed_mm_s > 0 ? 1 : -1);
      wire.push(newtons((i < cut ? taut_N : 1) + noise_N(random)), velocity(speed_mm_s));
      if (i < cut) {
        ASSERT_FALSE(wire.reading().broken) << seed;
        ASSERT_EQ(wire.reading().slack_events, 0u) << seed;
        released_mm = position_mm = 0;
        continue;
      }
      position_mm += std::fabs(speed_mm_s) > 1 ? speed_mm_s * 1e-3 : 0;
      released_mm = std::min(released_mm, position_mm);
      if (wire.reading().broken) {
        found = i;
        // The first sample that finds it, and none before.
        EXPECT_GE(position_mm - released_mm, 20 - 1e-3) << seed;
        EXPECT_LT(position_mm - released_mm, 20 + 1e-3 + std::fabs(speed_mm_s) * 1e-3) << seed;
      }
    }
    EXPECT_GE(found, cut) << seed;
  }
}

}  // namespace
}  // namespace lifemodel
