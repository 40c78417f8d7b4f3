#include "host_sim/report/replay/plot_builders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace host_sim {
namespace {

using testing::ElementsAre;

TEST(EnvelopeBuilder, FewSamplesStayAsTheyAre) {
  EnvelopeBuilder builder(4);
  builder.push(0, 3);
  builder.push(1, 1);
  builder.push(5, 2);
  const Envelope envelope = builder.finish();
  EXPECT_EQ(envelope.samples_per_bucket, 1U);
  EXPECT_THAT(envelope.time_s, ElementsAre(0, 1, 5));
  EXPECT_THAT(envelope.low_N, ElementsAre(3, 1, 2));
  EXPECT_THAT(envelope.high_N, ElementsAre(3, 1, 2));
}

TEST(EnvelopeBuilder, PairsMergeWhenFull) {
  EnvelopeBuilder builder(4);
  double time_s = 0;
  for (const double value : {5, 1, 2, 8, 3, 9, 4}) {
    builder.push(time_s++, value);
  }
  const Envelope envelope = builder.finish();
  EXPECT_EQ(envelope.samples_per_bucket, 2U);
  EXPECT_THAT(envelope.time_s, ElementsAre(0.5, 2.5, 4.5, 6));
  EXPECT_THAT(envelope.low_N, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(envelope.high_N, ElementsAre(5, 8, 9, 4));
}

TEST(EnvelopeBuilder, EveryBucketHasTheExactExtremesOfItsSamples) {
  constexpr std::size_t kMaxBuckets = 100;
  std::mt19937 random(1);
  EnvelopeBuilder builder(kMaxBuckets);
  std::vector<double> values;
  for (int i = 0; i < 12'345; ++i) {
    values.push_back(static_cast<double>(random()));
    builder.push(i, values.back());
  }
  const Envelope envelope = builder.finish();
  ASSERT_LE(envelope.time_s.size(), kMaxBuckets);
  ASSERT_GT(envelope.time_s.size(), kMaxBuckets / 2);
  for (std::size_t bucket = 0; bucket < envelope.time_s.size(); ++bucket) {
    const std::size_t first = bucket * envelope.samples_per_bucket;
    const std::size_t last =
        std::min<std::size_t>(first + envelope.samples_per_bucket, values.size()) - 1;
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    EXPECT_EQ(envelope.low_N[bucket], *std::min_element(begin, end));
    EXPECT_EQ(envelope.high_N[bucket], *std::max_element(begin, end));
    EXPECT_EQ(envelope.time_s[bucket], static_cast<double>(first + last) / 2);
  }
}

TEST(EnvelopeBuilder, NoBucketReachesOverAGap) {
  EnvelopeBuilder builder(4);
  builder.gap();  // before the first sample nothing is missing
  double time_s = 0;
  for (const double value : {5, 1, 2, 8, 3}) {
    if (value == 8) {
      time_s += 10;
      builder.gap();
    }
    builder.push(time_s++, value);
  }
  // 5 1 | 2, gap, 8 3: pairs do not merge over the gap.
  const Envelope envelope = builder.finish();
  EXPECT_THAT(envelope.gaps, ElementsAre(2));
  EXPECT_THAT(envelope.time_s, ElementsAre(0.5, 2, 13, 14));
  EXPECT_THAT(envelope.low_N, ElementsAre(1, 2, 8, 3));
  EXPECT_THAT(envelope.high_N, ElementsAre(5, 2, 8, 3));
}

TEST(EnvelopeBuilder, BucketsReachOverGapsWhereThereAreTooMany) {
  EnvelopeBuilder builder(4);
  for (int i = 0; i < 1000; ++i) {
    builder.gap();
    builder.push(i, i);
  }
  const Envelope envelope = builder.finish();
  EXPECT_LE(envelope.time_s.size(), 4U);
  EXPECT_EQ(envelope.low_N.front(), 0);
  EXPECT_EQ(envelope.high_N.back(), 999);
}

TEST(EnvelopeBuilder, NothingGivesNothing) {
  EXPECT_TRUE(EnvelopeBuilder().finish().time_s.empty());
}

std::vector<double> tensions_of(const TurningPoints& turning_points) {
  std::vector<double> tensions;
  for (const TurningPoint& point : turning_points.points) {
    tensions.push_back(point.tension_N);
  }
  return tensions;
}

TurningPoints of_values(std::size_t max_points, const std::vector<double>& values) {
  TurningPointBuilder builder(max_points);
  for (std::size_t i = 0; i < values.size(); ++i) {
    builder.push(static_cast<double>(i), values[i]);
  }
  return builder.finish();
}

TEST(TurningPointBuilder, KeepsAllInOrderWhileTheyFit) {
  const std::vector<double> values = {3, 1, 4, 1, 5, 1, 9, 2};
  for (std::size_t count = 0; count <= values.size(); ++count) {
    const std::vector<double> first(values.begin(),
                                    values.begin() + static_cast<std::ptrdiff_t>(count));
    const TurningPoints kept = of_values(8, first);
    EXPECT_EQ(tensions_of(kept), first);
    EXPECT_EQ(kept.total, count);
  }
}

TEST(TurningPointBuilder, ThinnedRunsKeepTheirLowestAndHighest) {
  const TurningPoints kept = of_values(4, {5, 2, 7, 3, 8, 1, 6, 4});
  EXPECT_EQ(tensions_of(kept), (std::vector<double>{2, 7, 8, 1}));
  EXPECT_EQ(kept.total, 8U);
}

TEST(TurningPointBuilder, EqualPointsInARunDoNotDouble) {
  const TurningPoints kept = of_values(4, {5, 5, 5, 5, 5});
  for (std::size_t i = 1; i < kept.points.size(); ++i) {
    EXPECT_LT(kept.points[i - 1].time_s, kept.points[i].time_s);
  }
}

TEST(TurningPointBuilder, IsABoundedSubsetWithTheExtremes) {
  std::mt19937 random(7);
  std::vector<double> values;
  for (int i = 0; i < 54'321; ++i) {
    values.push_back(static_cast<double>(random()));
  }
  const TurningPoints kept = of_values(200, values);
  ASSERT_LE(kept.points.size(), 200U);
  ASSERT_GE(kept.points.size(), 100U);
  EXPECT_EQ(kept.total, values.size());
  for (const TurningPoint& point : kept.points) {
    EXPECT_EQ(values[static_cast<std::size_t>(point.time_s)], point.tension_N);
  }
  EXPECT_TRUE(std::is_sorted(kept.points.begin(), kept.points.end(),
                             [](const auto& a, const auto& b) { return a.time_s < b.time_s; }));
  const std::vector<double> tensions = tensions_of(kept);
  EXPECT_EQ(*std::min_element(tensions.begin(), tensions.end()),
            *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(*std::max_element(tensions.begin(), tensions.end()),
            *std::max_element(values.begin(), values.end()));
}

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

using testing::ElementsAre;
using testing::IsEmpty;

Trajectory of_first_numbers(std::size_t max_points, int count) {
  TrajectoryBuilder builder(max_points);
  for (int i = 0; i < count; ++i) {
    builder.push(i, 10.0 * i);
  }
  return builder.finish();
}

TEST(TrajectoryBuilder, KeepsAllWhileTheyFit) {
  EXPECT_THAT(of_first_numbers(4, 0).time_s, IsEmpty());
  EXPECT_THAT(of_first_numbers(4, 1).time_s, ElementsAre(0));
  EXPECT_THAT(of_first_numbers(4, 4).time_s, ElementsAre(0, 1, 2, 3));
}

TEST(TrajectoryBuilder, ThinsByDoublingAndKeepsTheLast) {
  EXPECT_THAT(of_first_numbers(4, 5).time_s, ElementsAre(0, 2, 4));
  EXPECT_THAT(of_first_numbers(4, 6).time_s, ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(of_first_numbers(4, 10).time_s, ElementsAre(0, 4, 8, 9));
  EXPECT_THAT(of_first_numbers(4, 10).damage, ElementsAre(0, 40, 80, 90));
}

TEST(TrajectoryBuilder, IsBoundedWithFirstAndLastForAnyLength) {
  for (const int count : {1, 2, 99, 100, 101, 1023, 1024, 1025, 100'003}) {
    const Trajectory trajectory = of_first_numbers(100, count);
    EXPECT_LE(trajectory.time_s.size(), 101U);
    EXPECT_GE(trajectory.time_s.size(), static_cast<std::size_t>(std::min(count, 50)));
    EXPECT_EQ(trajectory.time_s.front(), 0);
    EXPECT_EQ(trajectory.time_s.back(), count - 1);
  }
}

TEST(LifeCurve, IsTheWeibullDistributionOfTheRepeats) {
  // Shape 2, damage 0.5: 99.9 % have broken at sqrt(ln 1000) / 0.5; half-way, 1 - 1000^(-1/4) have.
  const LifeCurve curve = life_curve(0.5, 2, 3);
  ASSERT_EQ(curve.repeats.size(), 3U);
  EXPECT_EQ(curve.repeats[0], 0);
  EXPECT_EQ(curve.broken[0], 0);
  EXPECT_NEAR(curve.repeats[1], 2.628260884, 1e-9);
  EXPECT_NEAR(curve.broken[1], 0.822172059, 1e-9);
  EXPECT_NEAR(curve.repeats[2], 5.256521769, 1e-9);
  EXPECT_NEAR(curve.broken[2], 0.999, 1e-12);
}

TEST(LifeCurve, IsEmptyWhereThereIsNoEnd) {
  EXPECT_TRUE(life_curve(0, 5.94).repeats.empty());
  EXPECT_TRUE(life_curve(std::numeric_limits<double>::quiet_NaN(), 5.94).repeats.empty());
  EXPECT_TRUE(life_curve(std::numeric_limits<double>::infinity(), 5.94).repeats.empty());
  EXPECT_TRUE(life_curve(1e-310, 0.5).repeats.empty());
  EXPECT_TRUE(life_curve(0.5, 0).repeats.empty());
}

}  // namespace

}  // namespace host_sim
