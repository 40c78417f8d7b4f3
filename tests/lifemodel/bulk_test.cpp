#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "bulk_runs.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using lifemodel_test::Signal;

// Cycles whose quotient, divided in double, rounds up across a step of the exact one; found by
// trying 10^9 random ones. Their damage is that of the next step up unless the doubt is noticed.
constexpr std::array<std::pair<std::int32_t, std::int32_t>, 12> kHardCycles = {{
    {65359011, 173869751},
    {300137964, 267904377},
    {482920020, 279893490},
    {507944283, 287082849},
    {440097205, 77254937},
    {530292104, 361241643},
    {123327302, 122307469},
    {288280514, 316565433},
    {151052603, 248087434},
    {200821395, 330160889},
    {192100065, 268542249},
    {307026634, 387844208},
}};

TEST(Bulk, CyclesWhoseQuotientIsInDoubtHaveTheirOwnDamage) {
  for (const bulk::Instructions* by : bulk::instructions()) {
    for (double exponent = 1; exponent <= 12; exponent += 0.125) {
      auto constants = paper_constants();
      constants.ipl_exponent = exponent;
      constants.ipl_scale = 1e4 * std::pow(constants.ultimate_tension_N, exponent);
      const CycleLaw law = parameters_of(constants).law;
      Damage expected;
      Flags flags;
      std::vector<std::int32_t> from;
      std::vector<std::int32_t> to;
      for (const auto& [x, y] : kHardCycles) {
        expected.add(law(Tension::from_raw(x), Tension::from_raw(y)), flags);
        from.push_back(x);
        to.push_back(y);
      }
      from.resize(from.size() + bulk::kSpare);
      to.resize(to.size() + bulk::kSpare);
      bulk::DamageSum sum;
      by->add_damages({from.data(), to.data(), kHardCycles.size()}, law, sum);
      EXPECT_EQ(sum.total(), expected) << by->name << ", exponent " << exponent;
    }
  }
}

// By hand: 0 40 10 30 20 50 0 closes 30-20 and 40-10 before the peak of 50, which the last sample
// confirms.
TEST(Bulk, WhatClosesIsTakenOut) {
  const Signal signal = newtons({0, 40, 10, 30, 20, 50, 0});
  const CycleLaw law = parameters_of(paper_constants()).law;
  Damage expected;
  Flags flags;
  expected.add(law(newtons(30), newtons(20)), flags);
  expected.add(law(newtons(40), newtons(10)), flags);
  for (const bulk::Instructions* by : bulk::instructions()) {
    bulk::Reducer reducer(*by);
    const auto all = reducer.reduce(signal, TensionRange::from_raw(1), law);
    ASSERT_TRUE(all);
    EXPECT_EQ(all->cycles, 2u);
    EXPECT_EQ(all->damage, expected);
    EXPECT_EQ(Signal(all->left.begin(), all->left.end()), newtons({0, 50, 0}));
    // Without the last sample the peak is not confirmed, so what it closes has to wait: the last
    // turning point is 20, and within 0 40 10 30 20 nothing closes.
    const auto before = reducer.reduce(std::span(signal).first(6), TensionRange::from_raw(1), law);
    ASSERT_TRUE(before);
    EXPECT_EQ(before->cycles, 0u);
    EXPECT_EQ(before->left.size(), 6u);
  }
}

// 30-20 is below a hysteresis of 15 N: it is not counted, and 40-10 still is.
TEST(Bulk, RangesBelowTheHysteresisAreNotCounted) {
  const Signal signal = newtons({0, 40, 10, 30, 20, 50, 0});
  const CycleLaw law = parameters_of(paper_constants()).law;
  Damage expected;
  Flags flags;
  expected.add(law(newtons(40), newtons(10)), flags);
  for (const bulk::Instructions* by : bulk::instructions()) {
    bulk::Reducer reducer(*by);
    const auto all = reducer.reduce(signal, distance(newtons(15), Tension{}), law);
    ASSERT_TRUE(all);
    EXPECT_EQ(all->cycles, 1u);
    EXPECT_EQ(all->damage, expected);
  }
}

TEST(Bulk, TurningPointsThatAreNotedOneByOneAreLeft) {
  const CycleLaw law = parameters_of(paper_constants()).law;
  const TensionRange hysteresis = distance(newtons(1), Tension{});
  for (const bulk::Instructions* by : bulk::instructions()) {
    bulk::Reducer reducer(*by);
    for (std::size_t place = 0; place < 20; ++place) {
      Signal signal(20, newtons(10));
      signal[place] = newtons(-0.9);
      EXPECT_TRUE(reducer.reduce(signal, hysteresis, law)) << by->name;
      signal[place] = newtons(-1.1);
      EXPECT_FALSE(reducer.reduce(signal, hysteresis, law)) << by->name << ' ' << place;
      signal[place] = Tension::from_raw(kUltimate.raw() - 1);
      EXPECT_TRUE(reducer.reduce(signal, hysteresis, law)) << by->name;
      signal[place] = kUltimate;
      EXPECT_FALSE(reducer.reduce(signal, hysteresis, law)) << by->name << ' ' << place;
    }
  }
}

// What is left would otherwise be counted twice as slowly and nobody would notice.
TEST(Bulk, LittleIsLeftOfManySamples) {
  const Parameters p = parameters_of(paper_constants());
  bulk::Reducer reducer(*bulk::instructions().front());
  for (const Signal& signal :
       {lifemodel_test::walk(1, bulk::Reducer::kMostSamples),
        lifemodel_test::white_noise(1, bulk::Reducer::kMostSamples, 0, 100)}) {
    const auto stretch = reducer.reduce(signal, p.hysteresis, p.law);
    ASSERT_TRUE(stretch);
    EXPECT_LT(stretch->left.size(), 100u);
    EXPECT_LT(stretch->nesting, 80u);
    EXPECT_GT(stretch->cycles, signal.size() / 5);
  }
}

TEST(Bulk, SpiralsThatOverflowTheResidueAreReplayed) {
  const Parameters p = parameters_of(paper_constants());
  for (const bool inwards : {false, true}) {
    for (std::size_t turns = 100; turns < 160; ++turns) {
      Signal signal = lifemodel_test::spiral(turns, 0.25, inwards);
      const Signal again = signal;
      signal.insert(signal.end(), again.begin(), again.end());
      Estimator<1> one_by_one({p});
      for (const Tension sample : signal) {
        one_by_one.push(0, sample);
        while (one_by_one.settle()) {
        }
      }
      const Reading expected = one_by_one.reading(0);
      for (const bulk::Instructions* by : bulk::instructions()) {
        Estimator<1> estimator({p});
        bulk::Replay(*by).take(estimator, 0, signal);
        const Reading ours = estimator.reading(0);
        EXPECT_EQ(ours.total, expected.total) << by->name << ' ' << turns;
        EXPECT_EQ(ours.closed_cycles, expected.closed_cycles) << by->name << ' ' << turns;
        EXPECT_EQ(ours.residue_overflows, expected.residue_overflows) << by->name << ' ' << turns;
      }
    }
  }
}

TEST(Bulk, AnySignalGivesTheStateOfSampleBySample) {
  for (std::uint32_t seed = 1; seed <= 400; ++seed) {
    const auto name = lifemodel_test::difference(seed);
    ASSERT_FALSE(name) << *name << ", seed " << seed;
  }
}

}  // namespace
}  // namespace lifemodel
