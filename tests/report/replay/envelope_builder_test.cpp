#include "host_sim/report/replay/envelope_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
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

TEST(EnvelopeBuilder, NothingGivesNothing) {
  EXPECT_TRUE(EnvelopeBuilder().finish().time_s.empty());
}

}  // namespace
}  // namespace host_sim
