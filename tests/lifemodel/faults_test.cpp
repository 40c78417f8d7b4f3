#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using lifemodel_test::Signal;
using pack::to_double;

struct SmallLayout {
  static constexpr std::size_t kResidue = 8;
  static constexpr std::size_t kQueue = 16;
};
struct LargeLayout {
  static constexpr std::size_t kResidue = 4096;
  static constexpr std::size_t kQueue = 4096;
};

template <class Layout>
Reading counted(const Parameters& p, const Signal& signal) {
  Estimator<1, Layout> estimator({p});
  estimator.replay(0, signal);
  return estimator.reading(0);
}

TEST(Faults, OverloadIsAWholeLifeAndCountingGoesOn) {
  Estimator<1> estimator({parameters_of(paper_constants())});
  const auto feed = [&](double t) {
    estimator.push(0, newtons(t));
    while (estimator.settle()) {
    }
  };
  for (const double t : {10.0, 60.0, 10.0, 60.0, 10.0}) {
    feed(t);
  }
  EXPECT_FALSE(estimator.reading(0).flags.has(Flag::overload));
  const double before = to_double(estimator.reading(0).total);
  feed(177.5);
  EXPECT_TRUE(estimator.reading(0).flags.has(Flag::overload)) << "before it is confirmed";
  EXPECT_EQ(estimator.reading(0).overloads.raw(), 1u);
  feed(10);
  feed(60);
  feed(10);
  const Reading r = estimator.reading(0);
  EXPECT_TRUE(r.flags.has(Flag::overload));
  EXPECT_EQ(r.overloads.raw(), 1u);
  // 10-177.5 and 177.5-10 are half cycles of a whole life each.
  EXPECT_NEAR(to_double(r.total), before + 1, 0.02);
  EXPECT_GT(to_double(r.total), 1);
}

TEST(Faults, NegativeTensionIsCountedAsItIs) {
  auto constants = paper_constants();
  constants.hysteresis_N = 1;
  Estimator<1> estimator({parameters_of(constants)});
  for (const double t : {-0.5, 20.0, -0.5, 20.0, -3.0, 20.0, 5.0}) {
    estimator.push(0, newtons(t));
    while (estimator.settle()) {
    }
  }
  const Reading r = estimator.reading(0);
  EXPECT_TRUE(r.flags.has(Flag::negative_tension));
  EXPECT_EQ(r.negatives.raw(), 1u) << "-0.5 N is within the hysteresis";
  using lifemodel_test::cycle_damage;
  const auto exact = static_cast<double>(
      cycle_damage(constants, -0.5, 20) + cycle_damage(constants, -0.5, 20) / 2 * 0 +
      cycle_damage(constants, 20, -3) / 2 + cycle_damage(constants, -3, 20) / 2 +
      cycle_damage(constants, 20, 5) / 2 + cycle_damage(constants, -0.5, 20) / 2);
  EXPECT_NEAR(to_double(r.total) / exact, 1, 2e-6);
}

TEST(Faults, AGapIsCountedOnceAndTheCountGoesOnAcrossIt) {
  const Parameters p = parameters_of(paper_constants());
  Estimator<1> gappy({p});
  Estimator<1> whole({p});
  const Signal signal = lifemodel_test::walk(4, 2000);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    gappy.push(0, signal[i]);
    whole.push(0, signal[i]);
    if (i % 500 == 250) {
      { gappy.push_missing(0, 7); }
    }
    while (gappy.settle() || whole.settle()) {
    }
  }
  const Reading r = gappy.reading(0);
  EXPECT_TRUE(r.flags.has(Flag::gap));
  EXPECT_EQ(r.gaps.raw(), 4u);
  EXPECT_EQ(r.missing_samples.raw(), 28u);
  EXPECT_EQ(r.total, whole.reading(0).total);
}

TEST(Faults, AFullResidueNeverLosesDamage) {
  for (const double exponent : {1.0, 1.38, 5.0, 12.0}) {
    auto constants = paper_constants();
    constants.ipl_exponent = exponent;
    constants.ipl_scale = 1e3 * std::pow(177.4, exponent);
    const Parameters p = parameters_of(constants);
    int overflowed = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
      Signal signal = lifemodel_test::spiral(60, 0.7, true);
      const Signal noise = lifemodel_test::white_noise(seed, 200, 0, 170);
      signal.insert(signal.end(), noise.begin(), noise.end());
      const Signal end = lifemodel_test::spiral(1 + seed % 60, 0.9, true);
      signal.insert(signal.end(), end.begin(), end.end());
      for (std::size_t n = 1; n <= signal.size(); n += 13) {
        const Signal prefix(signal.begin(), signal.begin() + static_cast<std::ptrdiff_t>(n));
        const Reading small = counted<SmallLayout>(p, prefix);
        const Reading exact = counted<LargeLayout>(p, prefix);
        ASSERT_FALSE(exact.flags.has(Flag::residue_overflow));
        ASSERT_GE(small.total, exact.total);
        ASSERT_EQ(small.flags.has(Flag::residue_overflow), small.residue_overflows.raw() != 0);
        overflowed += small.flags.has(Flag::residue_overflow) ? 1 : 0;
      }
    }
    EXPECT_GT(overflowed, 100) << "the test did not reach what it is about";
  }
}

TEST(Faults, ALateSettleNeverLosesDamage) {
  for (const double exponent : {1.0, 1.38, 5.0, 12.0}) {
    auto constants = paper_constants();
    constants.ipl_exponent = exponent;
    constants.ipl_scale = 1e3 * std::pow(177.4, exponent);
    const Parameters p = parameters_of(constants);
    std::mt19937 random(23);
    int overran = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
      const Signal signal = seed % 2 == 0 ? lifemodel_test::white_noise(seed, 300, 0, 170)
                                          : lifemodel_test::walk(seed, 300);
      Estimator<1, SmallLayout> late({p});
      Estimator<1, LargeLayout> exact({p});
      Damage before;
      for (const Tension sample : signal) {
        late.push(0, sample);
        exact.push(0, sample);
        const auto what = random() % 24;
        for (std::uint32_t i = 0; i < (what == 0 ? 20u : what == 1 ? 2u : 0u); ++i) {
          late.settle();
        }
        if (what == 2) {
          const Damage now = late.reading(0).total;
          ASSERT_LE(before, now);
          before = now;
        }
      }
      // The last run of an overrun ends with the next turning point.
      for (const double t : {170.0, 0.0, 170.0}) {
        (void)late.reading(0);
        late.push(0, newtons(t));
        exact.push(0, newtons(t));
      }
      const Reading r = late.reading(0);
      ASSERT_GE(r.total, exact.reading(0).total);
      overran += r.flags.has(Flag::overrun) ? 1 : 0;
    }
    EXPECT_GT(overran, 100) << "the test did not reach what it is about";
  }
}

TEST(Faults, AShortOverrunLosesNothingAndAddsNothing) {
  const Parameters p = parameters_of(paper_constants());
  Estimator<1, SmallLayout> late({p});
  Estimator<1, LargeLayout> exact({p});
  // 16 places; 18 turning points before the queue is settled again.
  for (int i = 0; i < 19; ++i) {
    const Tension t = newtons(50 + (i % 2 == 0 ? -1 : 1) * (5.0 + 2 * i));
    late.push(0, t);
    exact.push(0, t);
  }
  (void)late.reading(0);
  for (const double t : {90.0, 20.0, 80.0}) {
    late.push(0, newtons(t));
    exact.push(0, newtons(t));
  }
  const Reading r = late.reading(0);
  EXPECT_TRUE(r.flags.has(Flag::overrun));
  EXPECT_EQ(r.overruns.raw(), 0u);
  EXPECT_EQ(r.total, exact.reading(0).total);
}

TEST(Faults, SaturatedInputReachesTheReading) {
  Estimator<1> estimator({parameters_of(paper_constants())});
  estimator.push(0, pack::from_double<MotorCurrent>(120));  // 2471 N
  EXPECT_TRUE(estimator.reading(0).flags.has(Flag::saturated));
}

}  // namespace
}  // namespace lifemodel
