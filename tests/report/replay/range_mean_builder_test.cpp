#include "host_sim/report/replay/range_mean_builder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace host_sim {
namespace {

struct Cycle {
  double from_N;
  double to_N;
  double count;
  double damage;
};

RangeMeanMatrix matrix_of(const std::vector<Cycle>& cycles, double first_step_N) {
  RangeMeanBuilder builder(first_step_N);
  for (const Cycle& cycle : cycles) {
    builder.push(cycle.from_N, cycle.to_N, cycle.count, cycle.damage);
  }
  return builder.finish();
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Cycles whose numbers are small multiples of powers of two, so that sums are exact.
std::vector<Cycle> cycles_from(const std::vector<std::pair<int, int>>& ends) {
  std::vector<Cycle> cycles;
  for (const auto& [from, to] : ends) {
    const double damage = std::ldexp(1 + std::abs(from - to) % 64, -20);
    cycles.push_back({from / 8.0, to / 8.0, from % 2 == 0 ? 1.0 : 0.5, damage});
  }
  return cycles;
}

TEST(RangeMeanBuilder, NothingGivesNoClasses) {
  const RangeMeanMatrix matrix = RangeMeanBuilder(1).finish();
  EXPECT_EQ(matrix.ranges, 0U);
  EXPECT_EQ(matrix.means, 0U);
  EXPECT_TRUE(matrix.count.empty());
}

TEST(RangeMeanBuilder, PutsCyclesIntoTheirClasses) {
  // Ranges 2.5, 2.5 and 0.5; means 11.25, 11.25 and 13.25; classes 1 N wide.
  const RangeMeanMatrix matrix =
      matrix_of({{10, 12.5, 1, 0.25}, {12.5, 10, 0.5, 0.125}, {13, 13.5, 1, 0.5}}, 1);
  ASSERT_EQ(matrix.ranges, 3U);
  ASSERT_EQ(matrix.means, 3U);
  EXPECT_EQ(matrix.mean_min_N, 11);
  EXPECT_EQ(matrix.count, (std::vector<double>{0, 0, 1, 0, 0, 0, 1.5, 0, 0}));
  EXPECT_EQ(matrix.damage, (std::vector<double>{0, 0, 0.5, 0, 0, 0, 0.375, 0, 0}));
}

TEST(RangeMeanBuilder, MeansBelowZeroHaveClassesToo) {
  const RangeMeanMatrix matrix = matrix_of({{-3, -2, 1, 0}, {2, 3, 1, 0}}, 1);
  EXPECT_EQ(matrix.mean_min_N, -3);
  EXPECT_EQ(matrix.means, 6U);
  EXPECT_EQ(sum(matrix.count), 2);
}

TEST(RangeMeanBuilder, WidensOnlyTheAxisThatIsFull) {
  const RangeMeanMatrix matrix = matrix_of({{0, 1, 1, 0}, {-100, 101, 1, 0}}, 1);
  EXPECT_EQ(matrix.range_step_N, 4);  // 201 N need 64 classes of at least 3.2 N
  EXPECT_EQ(matrix.mean_step_N, 1);
}

TEST(RangeMeanBuilder, RefusesAClassWidthThatCannotGrow) {
  for (const double width : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(RangeMeanBuilder{width}, std::invalid_argument);
  }
}

TEST(RangeMeanBuilder, TakesHugeNumbers) {
  const RangeMeanMatrix matrix = matrix_of({{0, 1, 1, 0.5}, {-1e300, 1e300, 1, 0.5}}, 0.01);
  EXPECT_EQ(sum(matrix.count), 2);
  EXPECT_GE(64 * matrix.range_step_N, 2e300);
}

RC_GTEST_PROP(RangeMeanBuilderProperty, ConservesCountAndDamage, ()) {
  const auto cycles = cycles_from(*rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-20'000, 20'000), rc::gen::inRange(-20'000, 20'000))));
  const RangeMeanMatrix matrix = matrix_of(cycles, 0.125);
  double count = 0;
  double damage = 0;
  for (const Cycle& cycle : cycles) {
    count += cycle.count;
    damage += cycle.damage;
  }
  RC_ASSERT(sum(matrix.count) == count);
  RC_ASSERT(sum(matrix.damage) == damage);
  RC_ASSERT(matrix.ranges <= RangeMeanBuilder::kClasses);
  RC_ASSERT(matrix.means <= RangeMeanBuilder::kClasses);
  RC_ASSERT(matrix.count.size() == matrix.ranges * matrix.means);
  RC_ASSERT(matrix.damage.size() == matrix.ranges * matrix.means);
}

RC_GTEST_PROP(RangeMeanBuilderProperty, EachCountLiesInTheClassOfItsCycle, ()) {
  const auto cycles =
      cycles_from(*rc::gen::nonEmpty(rc::gen::container<std::vector<std::pair<int, int>>>(
          rc::gen::pair(rc::gen::inRange(-20'000, 20'000), rc::gen::inRange(-20'000, 20'000)))));
  RangeMeanMatrix matrix = matrix_of(cycles, 0.125);
  for (const Cycle& cycle : cycles) {
    const double range_N = std::abs(cycle.to_N - cycle.from_N);
    const double mean_N = (cycle.from_N + cycle.to_N) / 2;
    const auto range = static_cast<std::size_t>(range_N / matrix.range_step_N);
    const auto mean = static_cast<std::size_t>((mean_N - matrix.mean_min_N) / matrix.mean_step_N);
    RC_ASSERT(range < matrix.ranges);
    RC_ASSERT(mean < matrix.means);
    matrix.count[range * matrix.means + mean] -= cycle.count;
  }
  RC_ASSERT(std::all_of(matrix.count.begin(), matrix.count.end(), [](double n) { return n == 0; }));
}

RC_GTEST_PROP(RangeMeanBuilderProperty, TheOrderOfTheCyclesDoesNotMatter, ()) {
  auto cycles = cycles_from(*rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(-20'000, 20'000), rc::gen::inRange(-20'000, 20'000))));
  const RangeMeanMatrix forwards = matrix_of(cycles, 0.125);
  std::reverse(cycles.begin(), cycles.end());
  const RangeMeanMatrix backwards = matrix_of(cycles, 0.125);
  RC_ASSERT(forwards.range_step_N == backwards.range_step_N);
  RC_ASSERT(forwards.mean_step_N == backwards.mean_step_N);
  RC_ASSERT(forwards.mean_min_N == backwards.mean_min_N);
  RC_ASSERT(forwards.count == backwards.count);
  RC_ASSERT(forwards.damage == backwards.damage);
}

}  // namespace
}  // namespace host_sim
