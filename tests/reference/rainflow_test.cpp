#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

#include "tests/reference/counts.hpp"
#include "tests/reference/signals.hpp"

namespace host_sim::reference::testing {
namespace {

// By hand after the clause: 0-10 holds the start when 12 passes it; 3-8 lies inside and is full.
TEST(AstmRainflow, FullCyclesAreThoseWithoutTheStart) {
  const AstmCount count = count_astm(Signal{2, 10, 0, 8, 3, 12});
  ASSERT_EQ(count.entries.size(), 4U);
  EXPECT_EQ(count.entries[0].cycle, (Cycle{2, 10}));
  EXPECT_EQ(count.entries[0].count, 0.5);
  EXPECT_EQ(count.entries[1].cycle, (Cycle{8, 3}));
  EXPECT_EQ(count.entries[1].count, 1.0);
  EXPECT_EQ(count.entries[2].cycle, (Cycle{10, 0}));
  EXPECT_EQ(count.entries[2].count, 0.5);
  EXPECT_EQ(count.entries[3].cycle, (Cycle{0, 12}));
  EXPECT_EQ(count.entries[3].count, 0.5);
}

TEST(AstmRainflow, ARangeEqualToTheOneBeforeItCountsIt) {
  const AstmCount rising = count_astm(Signal{10, 0, 8, 2, 8});
  EXPECT_EQ(rising.entries.front().cycle, (Cycle{8, 2}));
  EXPECT_EQ(rising.entries.front().count, 1.0);
  const AstmCount falling = count_astm(Signal{0, 10, 2, 8, 2});
  EXPECT_EQ(falling.entries.front().cycle, (Cycle{2, 8}));
  EXPECT_EQ(falling.entries.front().count, 1.0);
}

TEST(FourPointRainflow, ClosesTheNestedPairAndKeepsTheRest) {
  const FourPointCount count = count_four_point(Signal{2, 10, 0, 8, 3, 12});
  EXPECT_EQ(count.closed, (std::vector<Cycle>{{8, 3}}));
  EXPECT_EQ(count.residue, (Signal{2, 10, 0, 12}));
}

TEST(FourPointRainflow, ClosesAPairAsWideAsItsNeighbours) {
  const FourPointCount count = count_four_point(Signal{0, 5, 0, 5, 0, 5});
  EXPECT_EQ(count.closed, (std::vector<Cycle>{{5, 0}, {5, 0}}));
  EXPECT_EQ(count.residue, (Signal{0, 5}));
}

TEST(FourPointRainflow, OneClosureLetsTheNextFollow) {
  const FourPointCount count = count_four_point(Signal{0, 10, 2, 8, 4, 6, -1});
  EXPECT_EQ(count.closed, (std::vector<Cycle>{{4, 6}, {2, 8}}));
  EXPECT_EQ(count.residue, (Signal{0, 10, -1}));
}

// The next double above the range before it: a difference would round to a tie.
TEST(Rainflow, NestingIsDecidedWithoutRounding) {
  const double a = 1.0;
  const double b = 1e16;
  const double c = std::nextafter(1.0, 0.0);
  EXPECT_EQ(b - a, b - c);
  EXPECT_EQ(count_four_point(Signal{c, b, a, b}).closed.size(), 1U);
  EXPECT_EQ(count_four_point(Signal{a, b, c, 2e16}).closed.size(), 0U);
  const AstmCount astm = count_astm(Signal{c, b, a, 2e16});
  ASSERT_EQ(astm.entries.size(), 2U);
  EXPECT_EQ(astm.entries[0].cycle, (Cycle{b, a}));
  EXPECT_EQ(astm.entries[0].count, 1.0);
}

RC_GTEST_PROP(Rainflow, AstmAndFourPointAreOneMultiset, ()) {
  const Signal points = turning_points(*any_signal());
  RC_ASSERT(half_cycles(count_astm(points)) == half_cycles(count_four_point(points)));
}

TEST(Rainflow, AstmAndFourPointAreOneMultisetOnLongSignals) {
  std::mt19937_64 random(20240501);
  for (const double step_N : {0.0, 0.5, 20.0}) {
    std::normal_distribution<double> normal(40.0, 15.0);
    Signal signal(200'000);
    for (double& tension_N : signal) {
      const double value_N = normal(random);
      tension_N = step_N > 0.0 ? step_N * std::round(value_N / step_N) : value_N;
    }
    const Signal points = turning_points(signal, 0.2);
    ASSERT_GT(points.size(), 50'000U);
    EXPECT_TRUE(half_cycles(count_astm(points)) == half_cycles(count_four_point(points)))
        << "step " << step_N << " N";
  }
}

RC_GTEST_PROP(Rainflow, EveryRangeIsHalfACycle, ()) {
  const Signal points = turning_points(*any_signal());
  const std::size_t ranges = points.empty() ? 0 : points.size() - 1;
  double cycles = 0.0;
  for (const auto& entry : count_astm(points).entries) {
    cycles += entry.count;
  }
  RC_ASSERT(2.0 * cycles == static_cast<double>(ranges));
  const FourPointCount count = count_four_point(points);
  RC_ASSERT(2 * count.closed.size() + count.residue.size() == points.size());
}

RC_GTEST_PROP(Rainflow, ScalingAndMirroringTheSignalDoTheSameToTheCount, ()) {
  const Signal points = turning_points(*any_signal());
  const double factor = *rc::gen::element(-8.0, -1.0, 0.25, 4.0);
  Signal scaled = points;
  for (double& point : scaled) {
    point *= factor;
  }
  const FourPointCount before = count_four_point(points);
  const FourPointCount after = count_four_point(scaled);
  RC_ASSERT(before.closed.size() == after.closed.size());
  for (std::size_t i = 0; i < before.closed.size(); ++i) {
    RC_ASSERT(after.closed[i].from_N == factor * before.closed[i].from_N);
    RC_ASSERT(after.closed[i].to_N == factor * before.closed[i].to_N);
  }
}

RC_GTEST_PROP(Rainflow, ReversingTimeKeepsTheMultiset, ()) {
  const Signal points = turning_points(*any_signal());
  const Signal reversed(points.rbegin(), points.rend());
  RC_ASSERT(half_cycles(count_four_point(points)) == half_cycles(count_four_point(reversed)));
  RC_ASSERT(half_cycles(count_astm(points)) == half_cycles(count_astm(reversed)));
}

// What is left is a front that widens and a tail that narrows, and its outermost pair is the
// widest range of the signal.
RC_GTEST_PROP(Rainflow, TheResidueWidensAndThenNarrows, ()) {
  const Signal residue = count_four_point(turning_points(*any_signal())).residue;
  bool narrowing = false;
  for (std::size_t i = 2; i < residue.size(); ++i) {
    const double range = std::abs(residue[i] - residue[i - 1]);
    const double before = std::abs(residue[i - 1] - residue[i - 2]);
    narrowing = narrowing || range < before;
    RC_ASSERT((narrowing ? range <= before : range >= before));
  }
}

}  // namespace
}  // namespace host_sim::reference::testing
