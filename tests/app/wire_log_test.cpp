#include "firmware/app/wire_log.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "lifemodel/extension/sample.hpp"
#include "lifemodel/pack/pack.hpp"
#include "rig.hpp"
#include "wire.hpp"

namespace app {
namespace {

using lifemodel::WatchReading;
using protocol::EmergencyCode;
using protocol::LifeStatus;
using storage::WireHistory;

const WireHistory kPast{.peak = 1u << 28,
                        .above_50 = 3,
                        .above_70 = 2,
                        .above_90 = 1,
                        .below_minimum_s = 10,
                        .slack_events = 4};

WireHistory history_of(std::uint32_t peak, std::uint32_t above_50, std::uint32_t above_70,
                       std::uint32_t above_90, std::uint32_t below_minimum_s,
                       std::uint32_t slack_events) {
  return {.peak = peak,
          .above_50 = above_50,
          .above_70 = above_70,
          .above_90 = above_90,
          .below_minimum_s = below_minimum_s,
          .slack_events = slack_events};
}

TEST(WireLog, AddsWhatIsSeenToWhatWasStored) {
  WireLog log;
  log.resume(kPast);
  EXPECT_EQ(log.history(), kPast);
  log.take({.peak = 1u << 27, .above = {5, 1, 0}, .below_minimum = 2'500, .slack_events = 1}, 1000);
  EXPECT_EQ(log.history(), (history_of(1u << 28, 8, 3, 1, 12, 5)));
  // Half a second is carried on.
  log.take({.peak = 1u << 29, .above = {6, 1, 2}, .below_minimum = 3'000, .slack_events = 1}, 1000);
  EXPECT_EQ(log.history(), (history_of(1u << 29, 9, 3, 3, 13, 5)));
}

TEST(WireLog, CountsTheSecondsInWhichItWasOperated) {
  WireLog log;
  log.resume({.operated_s = 100});
  log.operate(2'700'000);
  EXPECT_EQ(log.history().operated_s, 102u);
  log.operate(300'000);
  EXPECT_EQ(log.history().operated_s, 103u);
  log.operate(999'999);
  log.begin();
  log.operate(1);
  EXPECT_EQ(log.history().operated_s, 0u);
}

TEST(WireLog, CountsWrapAndHistoriesStop) {
  WireLog log;
  log.resume({.above_50 = 0xffff'fffe});
  log.take({.above = {0xffff'fff0, 0xffff'fff0, 0}}, 1000);
  EXPECT_EQ(log.history().above_50, 0xffff'ffffu);
  log.begin();
  log.take({.above = {0, 3, 0}}, 1000);
  EXPECT_EQ(log.history().above_50, 16u);
  EXPECT_EQ(log.history().above_70, 19u);
}

TEST(WireLog, AWireThatBrokeStaysBrokenAndIsNotSlackBesides) {
  WireLog log;
  log.take({.slack_events = 1, .slack = true}, 1000);
  EXPECT_TRUE(log.slack());
  log.take({.slack_events = 1, .broken = true}, 1000);
  EXPECT_TRUE(log.history().broken);
  EXPECT_FALSE(log.slack());
  const WireHistory stored = log.history();
  WireLog after;
  after.resume(stored);
  after.take({.slack_events = 2, .slack = true}, 1000);
  EXPECT_TRUE(after.history().broken);
  EXPECT_FALSE(after.slack());
  EXPECT_EQ(after.history().slack_events, 1u);
}

TEST(WireLog, ANewWireHasNoHistory) {
  WireLog log;
  log.resume(kPast);
  log.take({.peak = 7, .above = {5, 5, 5}, .below_minimum = 500, .slack = true, .broken = true},
           1000);
  log.begin();
  EXPECT_EQ(log.history(), WireHistory{});
  EXPECT_FALSE(log.slack());
  log.take({.peak = 9, .above = {6, 5, 5}, .below_minimum = 1'400}, 1000);
  EXPECT_EQ(log.history(), (WireHistory{.peak = 9, .above_50 = 1}));
  log.take({.peak = 9, .above = {6, 5, 5}, .below_minimum = 1'500}, 1000);
  EXPECT_EQ(log.history().below_minimum_s, 1u);
}

/// An application whose sensor tells the velocity of the tendon: slack below 5 N over 4 mm, broken
/// at no more than 2 N over 20 mm.
class WatchedApp : public testing::Test {
 protected:
  using Sample = Moving<lifemodel::Tension>;

  void SetUp() override {
    lifemodel::WatchLimits& limits = rig.models[0]->nominal.watch;
    limits.minimum = lifemodel::pack::tension(5, 177.4);
    limits.broken = lifemodel::pack::tension(2, 177.4);
    limits.broken_travel_um = 20'000;
    limits.slack_travel_um = 4'000;
    rig.start();
  }
  /// At 100 mm/s, 0.1 mm a period; negative is back.
  void move(double tension_N, double travel_mm) {
    const Sample sample{lifemodel::pack::tension(tension_N, 177.4),
                        lifemodel::pack::from_double<Velocity>(travel_mm < 0 ? -0.1 : 0.1)};
    for (int i = 0; i < std::lround(std::fabs(travel_mm) * 10); ++i) {
      rig.step(sample);
    }
  }
  void stand(double tension_N, int periods) {
    for (int i = 0; i < periods; ++i) {
      rig.step(Sample{lifemodel::pack::tension(tension_N, 177.4)});
    }
  }
  /// Until what was sampled is read and told.
  void settle(double tension_N = 30) { stand(tension_N, 400); }

  [[nodiscard]] std::vector<EmergencyCode> told() const {
    std::vector<EmergencyCode> codes;
    for (const protocol::Emergency& emergency : rig.sent<protocol::Emergency>()) {
      codes.push_back(emergency.code);
    }
    return codes;
  }
  [[nodiscard]] LifeStatus status() const { return rig.sent<LifeStatus>().back(); }
  [[nodiscard]] std::vector<storage::LogEntry> lines() {
    std::vector<storage::LogEntry> lines;
    for (std::uint32_t i = 0; const auto line = rig.store.log(i); ++i) {
      lines.push_back(*line);
    }
    return lines;
  }
  [[nodiscard]] const WireHistory& history() const { return rig.app->lives().records()[0].history; }

  Rig<1, Sample> rig;
};

TEST_F(WatchedApp, TellsThatATendonIsSlackAndWhenItIsOver) {
  settle();
  EXPECT_FALSE(status().slack);
  move(3, -4.1);
  settle(3);
  EXPECT_TRUE(status().slack);
  EXPECT_FALSE(status().broken);
  EXPECT_EQ(told(), (std::vector<EmergencyCode>{EmergencyCode::tendon_slack}));
  settle(30);
  EXPECT_FALSE(status().slack);
  EXPECT_EQ(told(), (std::vector<EmergencyCode>{EmergencyCode::tendon_slack, EmergencyCode::none}));
  EXPECT_EQ(history().slack_events, 1u);
  move(3, -4.1);
  settle();
  EXPECT_EQ(history().slack_events, 2u);
  // The first time of a wire is a line in the log.
  ASSERT_EQ(lines().size(), 1u);
  EXPECT_EQ(lines()[0].event, storage::Event::tendon_slack);
}

TEST_F(WatchedApp, TellsABreakSavesItAtOnceAndWritesALine) {
  for (int i = 0; i < 10; ++i) {
    stand(60, 20);
    stand(10, 20);
  }
  settle();
  const std::uint32_t saves = rig.store.sequence();
  move(1, 20.1);
  stand(1, 110);
  EXPECT_EQ(rig.store.sequence(), saves + 1);
  settle(1);
  EXPECT_TRUE(status().broken);
  EXPECT_FALSE(status().slack);
  EXPECT_TRUE(history().broken);
  const auto codes = told();
  EXPECT_NE(std::find(codes.begin(), codes.end(), EmergencyCode::tendon_broken), codes.end());
  ASSERT_EQ(lines().size(), 2u);
  EXPECT_EQ(lines()[1].event, storage::Event::tendon_broken);
  EXPECT_EQ(lines()[1].tendon, 0);
  EXPECT_EQ(lines()[1].epoch, 0);
  EXPECT_EQ(lines()[1].detail, rig.app->lives().records()[0].epoch_cycles);
  EXPECT_GE(lines()[1].detail, 9u);
  // However the tension goes on.
  settle(60);
  EXPECT_TRUE(status().broken);
  EXPECT_EQ(lines().size(), 2u);
}

TEST_F(WatchedApp, ABreakOutlivesAPowerCut) {
  // A save at once is one a second at most.
  stand(100, 1'000);
  move(1, 20.1);
  stand(1, 1'500);
  ASSERT_TRUE(history().broken);
  const std::size_t lines_before = lines().size();
  rig.start();
  settle(1);
  EXPECT_TRUE(history().broken);
  EXPECT_TRUE(status().broken);
  EXPECT_EQ(told().back(), EmergencyCode::tendon_broken);
  EXPECT_EQ(lines().size(), lines_before);
  EXPECT_EQ(history().above_50, 1u);
}

TEST_F(WatchedApp, SeesPeaksExcursionsAndTimeWithoutMotion) {
  stand(170, 5);
  stand(100, 5);
  stand(80, 5);
  stand(130, 5);
  stand(1, 2'500);
  settle();
  EXPECT_EQ(
      history(),
      (WireHistory{.peak = static_cast<std::uint32_t>(lifemodel::pack::tension(170, 177.4).raw()),
                   .above_50 = 2,
                   .above_70 = 2,
                   .above_90 = 1,
                   .below_minimum_s = 2,
                   .operated_s = 2}));
  EXPECT_TRUE(told().empty());
}

/// 170 N of 177.4 N are 95.8 %; 66 s below the minimum.
TEST_F(WatchedApp, APageTellsTheHistoryOfTheWire) {
  using protocol::WireEvent;
  using protocol::detail::WireHistory;
  stand(170, 5);
  stand(100, 5);
  stand(80, 5);
  stand(130, 5);
  stand(1, 66'000);
  const auto pages = rig.sent<WireHistory>();
  ASSERT_GT(pages.size(), 8u);
  WireHistory expected{.peak_percent = 96, .below_minimum_min = 1};
  for (const auto& [event, count] :
       {std::pair{WireEvent::above_50, 2}, std::pair{WireEvent::above_70, 2},
        std::pair{WireEvent::above_90, 1}, std::pair{WireEvent::slack, 0}}) {
    expected.event = event;
    expected.count = static_cast<std::uint16_t>(count);
    EXPECT_NE(std::find(pages.end() - 4, pages.end(), expected), pages.end()) << count;
  }
  move(1, 20.1);
  stand(1, 6'000);
  const WireHistory last = rig.sent<WireHistory>().back();
  EXPECT_TRUE(last.broken);
  EXPECT_FALSE(last.slack);
}

}  // namespace
}  // namespace app
