#include "firmware/storage/save_policy.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <vector>

namespace storage_test {
namespace {

using storage::SavePolicy;
using storage::Wear;

// 16 pages of 23 records at 10,000 erases; 3,680,000 minutes are 6.997 years of 365.25 days.
static_assert(Wear{}.writes() == 3'680'000);
static_assert(Wear{}.years_x10(1, 60) == 69);
static_assert(Wear{}.years_x10(2, 60) == 34);
static_assert(Wear{}.years_x10(4, 60) == 17);
// 46 records in 4 KiB.
static_assert(Wear{.pages = 2, .page_bytes = 4'096, .erases = 100'000}.writes() == 9'200'000);
static_assert(SavePolicy::kPeriod == hal::seconds(60));

constexpr hal::Time kStart = hal::seconds(1'000);

SavePolicy started() {
  SavePolicy policy;
  policy.start(kStart);
  return policy;
}

/// How often it asks in `span`, asked every `every` while damage moves without end.
std::uint32_t saves(SavePolicy& policy, hal::Time from, hal::Time span, hal::Time every) {
  std::uint32_t count = 0;
  for (hal::Time now = from; now < from + span; now = now + every) {
    if (policy.due(now, 1'000'000, true)) {
      policy.saved(now);
      ++count;
    }
  }
  return count;
}

TEST(SavePolicy, NothingUnsavedIsNotSaved) {
  const SavePolicy policy = started();
  EXPECT_FALSE(policy.due(kStart + hal::seconds(1'000'000), 0, false));
}

TEST(SavePolicy, EveryMinuteWhereAnythingIsUnsaved) {
  SavePolicy policy = started();
  EXPECT_FALSE(policy.due(kStart + hal::microseconds(59'999'999), 1, false));
  EXPECT_TRUE(policy.due(kStart + hal::seconds(60), 1, false));
  policy.saved(kStart + hal::seconds(60));
  EXPECT_FALSE(policy.due(kStart + hal::microseconds(119'999'999), 999, false));
  EXPECT_TRUE(policy.due(kStart + hal::seconds(120), 999, false));
}

TEST(SavePolicy, SoonWhereDamageMovedByAMillionthOrSomethingChanged) {
  const SavePolicy policy = started();
  EXPECT_FALSE(policy.due(kStart + hal::microseconds(999'999), 1'000, true));
  EXPECT_TRUE(policy.due(kStart + hal::seconds(1), 1'000, false));
  EXPECT_FALSE(policy.due(kStart + hal::seconds(1), 999, false));
  EXPECT_TRUE(policy.due(kStart + hal::seconds(1), 0, true));
}

TEST(SavePolicy, AFreshStartHasCreditForFour) {
  SavePolicy policy = started();
  EXPECT_EQ(saves(policy, kStart, hal::seconds(60), hal::milliseconds(100)), 4u);
  // Spent: from then on one a minute.
  EXPECT_EQ(saves(policy, kStart + hal::seconds(60), hal::seconds(600), hal::seconds(1)), 10u);
}

TEST(SavePolicy, AQuietHourEarnsSixty) {
  SavePolicy policy = started();
  const hal::Time later = kStart + hal::seconds(10'000);
  EXPECT_EQ(saves(policy, later, hal::seconds(60), hal::seconds(1)), 60u);
  EXPECT_EQ(saves(policy, later + hal::seconds(60), hal::seconds(600), hal::seconds(1)), 10u);
}

TEST(SavePolicy, AFailureCountsAsASave) {
  SavePolicy policy = started();
  policy.failed(kStart + hal::seconds(1));
  EXPECT_FALSE(policy.due(kStart + hal::milliseconds(1'999), 5'000, true));
  EXPECT_TRUE(policy.due(kStart + hal::seconds(2), 5'000, true));
  for (std::uint64_t s = 2; s < 5; ++s) {
    policy.failed(kStart + hal::seconds(s));
  }
  EXPECT_FALSE(policy.due(kStart + hal::seconds(6), 5'000, true));
}

// Damage that moves by 1e-6 every second for a month: no more than one save a minute, so that the
// years of `Wear` at one a minute are the least there are.
TEST(SavePolicy, WritingIsBounded) {
  SavePolicy policy = started();
  constexpr std::uint64_t kMonth_s = 30 * 86'400;
  const std::uint32_t count = saves(policy, kStart, hal::seconds(kMonth_s), hal::seconds(1));
  EXPECT_LE(count, kMonth_s / 60 + SavePolicy::kCredit);
  EXPECT_GE(count, kMonth_s / 60);
}

TEST(SavePolicy, BoundedOverAnySpanWhateverHappens) {
  EXPECT_TRUE(rc::check([](const std::vector<std::uint16_t>& waits_ms, bool changed) {
    SavePolicy policy = started();
    std::vector<hal::Time> at;
    hal::Time now = kStart;
    for (const std::uint16_t wait_ms : waits_ms) {
      now = now + hal::milliseconds(wait_ms % 7 == 0 ? wait_ms * 100u : wait_ms);
      if (policy.due(now, 1'000, changed)) {
        policy.saved(now);
        at.push_back(now);
      }
    }
    for (std::size_t from = 0; from < at.size(); ++from) {
      for (std::size_t to = from; to < at.size(); ++to) {
        const std::uint64_t allowed = (at[to] - at[from]).us / 60'000'000 + SavePolicy::kCredit;
        RC_ASSERT(to - from + 1 <= allowed);
      }
    }
  }));
}

}  // namespace
}  // namespace storage_test
