#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "lifemodel/counting/rainflow.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::to_newtons;
using Pair = std::pair<double, double>;

struct Counted {
  std::vector<Pair> full, half;
  int overflows = 0;

  struct Sink {
    Counted& counted;
    void full(Tension a, Tension b) { counted.full.emplace_back(to_newtons(a), to_newtons(b)); }
    void half(Tension a, Tension b) { counted.half.emplace_back(to_newtons(a), to_newtons(b)); }
    void overflow() { ++counted.overflows; }
  };
};

/// Counts turning points (neighbours must turn); the last one stays unconfirmed.
template <std::size_t kCapacity>
Counted count(const std::vector<double>& turning_points_N, std::int32_t effort) {
  Counted counted;
  Counted::Sink sink{counted};
  Residue<kCapacity> residue;
  std::vector<FullCycle> closed(static_cast<std::size_t>(effort + 1) / 2);
  const auto points = newtons(turning_points_N);
  std::size_t position = 0;
  while (position + 1 < points.size()) {
    const auto done = residue.take(
        [&](std::uint32_t i) { return points[i]; }, static_cast<std::uint32_t>(position),
        static_cast<std::uint32_t>(points.size() - 1), effort, closed.data(), sink);
    position += done.taken;
    for (std::uint32_t i = 0; i < done.closed; ++i) {
      sink.full(closed[i].from(), closed[i].to());
    }
  }
  residue.open(points.back(), sink);
  return counted;
}

using Pairs = std::vector<Pair>;

TEST(Residue, AstmExample) {
  // ASTM E1049-85, 5.4.4, figure 6.
  const auto counted = count<16>({-2, 1, -3, 5, -1, 3, -4, 4, -2}, 4);
  EXPECT_EQ(counted.full, (Pairs{{-1, 3}}));
  EXPECT_EQ(counted.half, (Pairs{{-2, 1}, {1, -3}, {-3, 5}, {5, -4}, {-4, 4}, {4, -2}}));
}

TEST(Residue, ConstantAmplitudeClosesFullCycles) {
  const auto counted = count<16>({0, 10, 0, 10, 0, 10}, 4);
  EXPECT_EQ(counted.full, (Pairs{{10, 0}, {10, 0}}));
  EXPECT_EQ(counted.half, (Pairs{{0, 10}}));
}

TEST(Residue, OneTurningPointClosesManyCycles) {
  const auto counted = count<16>({0, 10, 1, 9, 2, 8, 3, 12, 0}, 4);
  EXPECT_EQ(counted.full, (Pairs{{8, 3}, {9, 2}, {10, 1}}));
  EXPECT_EQ(counted.half, (Pairs{{0, 12}, {12, 0}}));
}

TEST(Residue, TheEffortOfACallDoesNotMatter) {
  const std::vector<double> points{0, 10, 1, 9, 2, 8, 3, 12, -1, 5, 4, 13, 2, 6, 5, 6.5, 1};
  const auto one = count<16>(points, 1);
  for (const std::int32_t effort : {2, 3, 4, 100}) {
    const auto other = count<16>(points, effort);
    EXPECT_EQ(one.full, other.full);
    EXPECT_EQ(one.half, other.half);
  }
}

TEST(Residue, AGrowingFrontTakesNoPlaces) {
  std::vector<double> growing;
  for (int i = 0; i < 200; ++i) {
    growing.push_back(i % 2 == 0 ? -i : i);
  }
  const auto counted = count<4>(growing, 4);
  EXPECT_EQ(counted.overflows, 0);
  EXPECT_TRUE(counted.full.empty());
  ASSERT_EQ(counted.half.size(), 199u);
  EXPECT_EQ(counted.half.front(), (Pair{0, 1}));
  EXPECT_EQ(counted.half.back(), (Pair{-198, 199}));
}

TEST(Residue, LevelsNestAtMostTwiceTheirNumberLessOne) {
  // 8 levels: 0 7 1 6 2 5 3 4 and back out; 2 * 8 - 1 places are never exceeded.
  const auto counted = count<15>({0, 7, 0, 7, 1, 6, 1, 6, 2, 5, 2, 5, 3, 4, 3, 4, 3}, 4);
  EXPECT_EQ(counted.overflows, 0);
}

TEST(Residue, WhenFullTheSmallestCycleGivesWayAndIsCountedLarger) {
  // Places for 0 10 1 9; 2 has none: 1-9 is counted as a full cycle, 9 and 2 are forgotten.
  const auto counted = count<4>({0, 10, 1, 9, 2, 8}, 4);
  EXPECT_EQ(counted.overflows, 1);
  EXPECT_EQ(counted.full, (Pairs{{1, 9}}));
  EXPECT_EQ(counted.half, (Pairs{{0, 10}, {10, 1}, {1, 8}}));
}

}  // namespace
}  // namespace lifemodel
