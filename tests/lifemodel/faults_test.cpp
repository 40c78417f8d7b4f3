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

/// A sample at the ultimate tension is one, whatever follows: here nothing that turns. The way up
/// from no tension is half a cycle of a whole life.
TEST(Faults, TensionHeldAtTheUltimateOneIsAnOverload) {
  auto constants = paper_constants();
  constants.hysteresis_N = 0.2;
  const Parameters p = parameters_of(constants);
  for (const double held_N : {177.4, 200.0, -177.4}) {
    Estimator<1> held({p});
    for (int i = 0; i < 1000; ++i) {
      held.push(0, newtons(held_N + (i % 3 == 1 ? 0.01 : 0)));
      EXPECT_FALSE(held.settle());
    }
    const Reading r = held.reading(0);
    EXPECT_TRUE(r.flags.has(Flag::overload)) << held_N;
    EXPECT_EQ(r.overloads.raw(), 1u);
    EXPECT_EQ(r.open_half_cycles.raw(), 1u);
    EXPECT_EQ(to_double(r.total), 0.5);
    EXPECT_EQ(r.flags.has(Flag::negative_tension), held_N < 0);

    // exp(-0.5^5.94) = 0.98384
    EXPECT_NEAR(to_double(p.life.survival(r.total)), 0.98384, 1e-5);

    std::array<std::byte, Estimator<1>::kSnapshotBytes> buffer{};
    Estimator<1> resumed({p});
    ASSERT_EQ(resumed.restore(held.snapshot(buffer)), SnapshotError::none);
    EXPECT_TRUE(resumed.reading(0).flags.has(Flag::overload));
    EXPECT_EQ(resumed.reading(0).total, r.total);
  }
  Estimator<1> below({p});
  below.push(0, newtons(177.399));
  EXPECT_TRUE(below.reading(0).flags.none());
  EXPECT_EQ(below.reading(0).total, Damage{});
}

/// The same where settle() was too late for the turning points before it: of 16 places none is left
/// for the point 16 and those after it.
TEST(Faults, TensionHeldAtTheUltimateOneAfterAnOverrunIsAnOverload) {
  for (const int last : {17, 19, 21}) {
    for (const bool turns : {false, true}) {
      Estimator<1, SmallLayout> late({parameters_of(paper_constants())});
      for (int i = 0; i < last; ++i) {
        late.push(0, newtons(i % 2 == 0 ? 40 : 60));
      }
      late.push(0, newtons(177.4));
      if (turns) {
        late.push(0, newtons(30));
      }
      EXPECT_TRUE(late.reading(0).flags.has(Flag::overload)) << last << ' ' << turns;
      EXPECT_TRUE(late.reading(0).flags.has(Flag::overrun));
      for (const double tension_N : {20.0, 60.0, 20.0}) {
        late.push(0, newtons(tension_N));
      }
      EXPECT_EQ(late.reading(0).overloads.raw(), 1u);
      EXPECT_GE(to_double(late.reading(0).total), 0.5);
    }
  }
}

/// Every sample of every signal: the flag is there with the first sample that reaches the ultimate
/// tension and not before, with the damage of half a cycle at least, and the damage never falls.
TEST(Faults, AnOverloadIsToldWithItsFirstSample) {
  std::mt19937 random(41);
  for (int attempt = 0; attempt < 2000; ++attempt) {
    auto constants = paper_constants();
    constants.hysteresis_N = std::array{0.0, 0.2, 5.0, 40.0}[random() % 4];
    Estimator<1> estimator({parameters_of(constants)});
    std::uniform_real_distribution<double> near(-3, 3);
    double tension_N = attempt % 2 == 0 ? 177.4 : -177.4;
    bool overload = false;
    Reading before{};
    for (int i = 0; i < 40; ++i) {
      tension_N += random() % 8 == 0 ? 20 * near(random) : near(random);
      overload = overload || CycleLaw::overloads(newtons(tension_N));
      estimator.push(0, newtons(tension_N));
      while (random() % 4 == 0 && estimator.settle()) {
      }
      const Reading now = estimator.reading(0);
      ASSERT_EQ(now.flags.has(Flag::overload), overload) << "sample " << i;
      ASSERT_EQ(now.total >= Damage::from_words({0, 0, 0, 1u << 7}), overload);
      ASSERT_LE(before.total, now.total);
      before = now;
    }
  }
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
