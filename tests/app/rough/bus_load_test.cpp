#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/app/rough/scenario.hpp"

namespace app {
namespace {

/// What the application promises: 2.8 kbit/s, and 1,350 bits at once. Worst lengths by ISO 11898-1:
/// 47 + 8 n bits and a stuff bit after each 4 of the first 34 + 8 n less one; for extended frames
/// 67 and 54.
constexpr std::uint64_t kBitsPerSecond = 2'800;
constexpr std::uint64_t kBurstBits = 1'350;

std::uint64_t bits_of(const hal::CanFrame& frame) {
  return (frame.extended ? 80u : 55u) + 10u * frame.length;
}

/// The highest that a bucket gets which leaks at the promised rate. At most kBurstBits, and only
/// then, every span of time t holds at most kBurstBits + t * kBitsPerSecond.
std::uint64_t highest_level(const std::vector<hal::fake::CanEvent>& events) {
  constexpr std::uint64_t kMillionth = 1'000'000;
  std::uint64_t level = 0;  // in millionths of a bit
  std::uint64_t highest = 0;
  hal::Time last{};
  for (const hal::fake::CanEvent& event : events) {
    if (event.sender != 0) {
      continue;
    }
    level -= std::min(level, kBitsPerSecond * (event.time - last).us);
    level += kMillionth * bits_of(event.frame);
    highest = std::max(highest, level);
    last = event.time;
  }
  return (highest + kMillionth - 1) / kMillionth;
}

TEST(BusLoad, OfABucketIsAsWorkedOutByHand) {
  using hal::fake::CanEvent;
  const hal::CanFrame full{.id = 0x181, .length = 8};
  const hal::CanFrame beat{.id = 0x701, .length = 1};
  const hal::CanFrame answer{.id = 0x18daf105, .extended = true, .length = 8};
  EXPECT_EQ(highest_level({{{}, 0, full}, {{}, 0, beat}, {{}, 1, full}}), 135u + 65u);
  EXPECT_EQ(highest_level({{{}, 0, full}, {hal::milliseconds(10), 0, full}}), 135u - 28u + 135u);
  EXPECT_EQ(highest_level({{{}, 0, full}, {hal::seconds(1), 0, answer}}), 160u);
}

RC_GTEST_PROP(BusLoad, IsBoundedInEverySpanOfTime, (const Roughness& rough)) {
  Scenario scenario(rough);
  scenario.run(4'000);
  RC_ASSERT(highest_level(scenario.rig.bus.sent()) <= kBurstBits);
}

TEST(BusLoad, IsBoundedWhereEverythingWantsToSpeakAtOnce) {
  // After a silence the budget is full; then a burst, answers, and an emergency.
  Scenario scenario({.seed = 3, .commands_ppm = 500'000, .requests_ppm = 500'000});
  scenario.rig.can.faults.during(hal::milliseconds(1), hal::seconds(3), hal::fake::SendFault::full);
  scenario.rig.stop.edge_at(hal::milliseconds(2'990), true);
  scenario.run(10'000);
  const std::uint64_t level = highest_level(scenario.rig.bus.sent());
  EXPECT_LE(level, kBurstBits);
  EXPECT_GE(level, kBurstBits - 300) << "it was not made to speak";
}

/// Every event that the world saw begin is reported after that.
bool all_told(const Scenario& scenario) {
  return std::ranges::all_of(scenario.events(), [&](const Scenario::Event& event) {
    return std::ranges::any_of(scenario.rig.bus.sent(), [&](const hal::fake::CanEvent& sent) {
      const auto emergency = protocol::decode<protocol::Emergency>(sent.frame);
      return sent.sender == 0 && sent.time >= event.time && emergency &&
             emergency->code == event.code;
    });
  });
}

RC_GTEST_PROP(Emergency, IsNeverDropped, (const Roughness& rough)) {
  Scenario scenario(rough);
  scenario.run(4'000);
  scenario.calm();
  scenario.run(4'000);
  RC_CLASSIFY(!scenario.events().empty());
  RC_ASSERT(all_told(scenario));

  protocol::e2e::Checker checker(protocol::e2e::stream_of<protocol::Emergency>(kNode));
  std::optional<hal::Time> last;
  for (const hal::fake::CanEvent& sent : scenario.rig.bus.sent()) {
    if (sent.sender != 0 || checker.check(sent.frame) == protocol::e2e::Status::other_frame) {
      continue;
    }
    RC_ASSERT(!last || sent.time >= *last + hal::milliseconds(100));
    last = sent.time;
  }
  RC_ASSERT(checker.counts().lost + checker.counts().repeated + checker.counts().wrong_sequence +
                checker.counts().damaged ==
            0u);
}

TEST(Emergency, OfEveryKindLeavesThroughABusThatIsHardlyThere) {
  Scenario scenario({.seed = 5,
                     .full_ppm = 950'000,
                     .bus_offs = 2,
                     .missing_ppm = 3'000,
                     .missed_ppm = 2'000,
                     .unsaved_ppm = 900'000,
                     .stop_ppm = 3'000,
                     .babble = 20,
                     .highest_N = 199});
  scenario.run(20'000);
  scenario.calm();
  scenario.run(5'000);
  EXPECT_GT(scenario.events().size(), 20u);
  EXPECT_TRUE(all_told(scenario));
  for (const auto code : {protocol::EmergencyCode::emergency_stop, protocol::EmergencyCode::sensor,
                          protocol::EmergencyCode::overload, protocol::EmergencyCode::deadline,
                          protocol::EmergencyCode::bus, protocol::EmergencyCode::storage}) {
    const auto reported = scenario.rig.sent<protocol::Emergency>();
    EXPECT_TRUE(std::ranges::any_of(reported, [&](const auto& e) { return e.code == code; }))
        << std::hex << static_cast<unsigned>(code);
  }
}

}  // namespace
}  // namespace app
