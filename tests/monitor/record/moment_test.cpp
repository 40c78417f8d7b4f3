#include "host_sim/monitor/record/moment.hpp"

#include <gtest/gtest.h>

#include "hal/files/input_error.hpp"
#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor {
namespace {

using test::kMs;
using test::kS;

constexpr std::int64_t kStart_ns = 1'600'000'000 * kS;
constexpr std::int64_t kStart_us = kStart_ns / 1000;

/// Of node 5, which reports once a second: in second i a damage of i ppb.
void record(RecentFrames& frames, int seconds) {
  test::Sender sender(5);
  for (int i = 0; i < seconds; ++i) {
    frames.see(sender.heartbeat(kStart_ns + i * kS));
    frames.see(sender.damage(kStart_ns + i * kS + kMs, static_cast<std::uint32_t>(i)));
  }
}

FleetView bus() {
  FleetView now;
  now.source = "can0";
  now.bit_rate_bit_s = 1e6;
  return now;
}

Moment moment_after(const FrameArchive& frames, double seconds) {
  return moment_of(frames, bus(), kStart_us + static_cast<std::int64_t>(1e6 * seconds));
}

TEST(Moment, HasWhatWasSentUntilThen) {
  RecentFrames frames("can0");
  record(frames, 100);
  const Moment moment = moment_after(frames, 40.5);
  EXPECT_EQ(moment.view.now_ns, kStart_ns + 40 * kS + 500 * kMs);
  EXPECT_EQ(moment.view.source, "can0");
  EXPECT_EQ(moment.view.frames, 82u);  // of seconds 0 to 40
  const NodeView& node = moment.view.nodes.at(5);
  EXPECT_EQ(node.highest_damage_ppb, 40u);
  EXPECT_EQ(node.status->time_ns, kStart_ns + 40 * kS + kMs);
  EXPECT_FALSE(node.vanished);
  EXPECT_EQ(moment_after(frames, 40.0005).view.nodes.at(5).highest_damage_ppb, 39u);
}

TEST(Moment, AgesAreThoseOfThatTime) {
  RecentFrames frames("can0");
  record(frames, 10);
  EXPECT_FALSE(moment_after(frames, 9.1).view.nodes.at(5).status->stale);
  EXPECT_TRUE(moment_after(frames, 9.9).view.nodes.at(5).status->stale);
  EXPECT_FALSE(moment_after(frames, 11.9).view.nodes.at(5).vanished);
  EXPECT_TRUE(moment_after(frames, 12.1).view.nodes.at(5).vanished);
}

TEST(Moment, CountsBeginWithItsWindow) {
  RecentFrames frames("can0");
  record(frames, 1500);
  const Moment moment = moment_after(frames, 1000.5);
  EXPECT_EQ(moment.from_us, kStart_us + 400'500'000);
  EXPECT_EQ(moment.view.frames, 1200u);  // of seconds 401 to 1000
  EXPECT_EQ(moment.view.nodes.at(5).curve.front().damage_ppb, 401u);
}

TEST(Moment, IsEmptyWhereNothingWasSent) {
  RecentFrames frames("can0");
  EXPECT_TRUE(moment_after(frames, 1).view.nodes.empty());
  record(frames, 10);
  EXPECT_TRUE(moment_after(frames, -1).view.nodes.empty());
  EXPECT_TRUE(moment_after(frames, 700).view.nodes.empty());
}

}  // namespace
}  // namespace host_sim::monitor
