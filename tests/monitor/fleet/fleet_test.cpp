#include "host_sim/monitor/fleet/fleet.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor {
namespace {

using test::event_texts;
using test::kMs;
using test::kS;
using test::Sender;

constexpr std::size_t kHeartbeat = 0, kStatus = 1, kDetail = 2, kEmergency = 3;

const NodeView& node_of(const Fleet& fleet, protocol::Node node) {
  return fleet.view().nodes.at(node);
}

TEST(Fleet, ShowsAStatusThatPassedTheCheck) {
  Fleet fleet;
  Sender sender(5);
  const protocol::LifeStatus status{.state = protocol::LifeState::inspect,
                                    .damage_ppb = 121'000'000,
                                    .worst_tendon = 2,
                                    .quality = protocol::Quality::gaps,
                                    .storage_ok = true};
  fleet.see(sender.status(7 * kS, status));
  const NodeView& node = node_of(fleet, 5);
  ASSERT_TRUE(node.status);
  EXPECT_EQ(node.status->value, status);
  EXPECT_EQ(node.status->time_ns, 7 * kS);
  EXPECT_FALSE(node.status->stale);
  EXPECT_EQ(node.highest_damage_ppb, 121'000'000u);
  EXPECT_EQ(event_texts(node, EventKind::state), std::vector<std::string>{"inspect"});
}

TEST(Fleet, ShowsNothingOfAFrameWithAWrongBit) {
  for (int bit = 0; bit < 64; ++bit) {
    Fleet fleet;
    Sender sender(1);
    fleet.see(sender.heartbeat(0));
    fleet.see(sender.heartbeat(kMs));
    SeenFrame frame = sender.damage(2 * kMs, 1'000'000);
    frame.frame.data[static_cast<std::size_t>(bit / 8)] ^= std::byte{1} << (bit % 8);
    fleet.see(frame);
    const NodeView& node = node_of(fleet, 1);
    EXPECT_FALSE(node.status) << bit;
    EXPECT_EQ(node.highest_damage_ppb, 0u) << bit;
    EXPECT_EQ(node.streams[kStatus].damaged, 1u) << bit;
    EXPECT_EQ(node.integrity_failures(), 1u) << bit;
    EXPECT_EQ(event_texts(node, EventKind::integrity).size(), 1u) << bit;
  }
}

TEST(Fleet, KnowsNoNodeFromADamagedIdentifier) {
  Fleet fleet;
  Sender sender(1);
  SeenFrame status = sender.damage(0, 5);
  status.frame.id ^= 2;
  fleet.see(status);
  SeenFrame heartbeat = sender.heartbeat(kMs);
  heartbeat.frame.id ^= 4;
  fleet.see(heartbeat);
  EXPECT_TRUE(fleet.view().nodes.empty());
  EXPECT_EQ(fleet.view().frames, 2u);
  EXPECT_EQ(fleet.view().foreign_frames, 2u);
}

TEST(Fleet, CountsLostRepeatedAndWronglyOrderedFrames) {
  Fleet fleet;
  Sender sender(9);
  std::vector<SeenFrame> frames;
  for (int i = 0; i < 20; ++i) {
    frames.push_back(sender.damage(i * 100 * kMs, 10u + static_cast<std::uint32_t>(i)));
  }
  fleet.see(frames[0]);
  fleet.see(frames[1]);
  fleet.see(frames[1]);   // repeated
  fleet.see(frames[4]);   // 2 lost
  fleet.see(frames[10]);  // silent for longer than three cycles: begun anew
  fleet.see(frames[9]);   // late
  fleet.see(frames[10]);
  const StreamView& stream = node_of(fleet, 9).streams[kStatus];
  EXPECT_EQ(stream.frame, "LifeStatus");
  EXPECT_EQ(stream.good, 5u);  // 0, 1, 4, 10, and 10 after 9
  EXPECT_EQ(stream.lost, 2u);
  EXPECT_EQ(stream.repeated, 1u);
  EXPECT_EQ(stream.wrong_sequence, 1u);
  EXPECT_EQ(stream.silences, 1u);
  EXPECT_EQ(stream.damaged, 0u);
  EXPECT_EQ(node_of(fleet, 9).status->value.damage_ppb, 20u);
}

TEST(Fleet, NeverShowsAFrameThatWasReplayed) {
  Fleet fleet;
  Sender sender(9);
  const SeenFrame old = sender.damage(0, 7);
  fleet.see(old);
  for (int i = 1; i <= 5; ++i) {
    fleet.see(sender.damage(i * 100 * kMs, 1'000));
  }
  SeenFrame replayed = old;
  replayed.time_ns = 550 * kMs;
  fleet.see(replayed);
  EXPECT_EQ(node_of(fleet, 9).status->value.damage_ppb, 1'000u);
  EXPECT_EQ(node_of(fleet, 9).streams[kStatus].wrong_sequence, 1u);
}

// Three cycles of 100 ms: at 300 ms the value is as old as it may be.
TEST(Fleet, TurnsAStatusStaleAfterThreeCycles) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.damage(0, 1));
  fleet.tick(300 * kMs);
  EXPECT_FALSE(node_of(fleet, 3).status->stale);
  fleet.tick(301 * kMs);
  EXPECT_TRUE(node_of(fleet, 3).status->stale);
  fleet.see(sender.damage(400 * kMs, 2));
  EXPECT_FALSE(node_of(fleet, 3).status->stale);
}

// A turn is a page of each kind, 100 ms apart; two tendons take twice as long.
TEST(Fleet, GivesPagesTheTimeOfTheirTurns) {
  Fleet fleet;
  Sender sender(3);
  constexpr std::int64_t kThreeTurns = 3 * protocol::detail::kPages * 100 * kMs;
  fleet.see(sender.page(0, protocol::detail::DamageRate{.ppb_per_h = 5}));
  fleet.see(sender.page(0, protocol::detail::TendonDamage{.tendon = 0, .damage_ppb = 1}));
  fleet.see(sender.page(0, protocol::detail::TendonDamage{.tendon = 1, .damage_ppb = 2}));
  fleet.see(sender.heartbeat(kThreeTurns - kMs));  // it has not vanished
  fleet.tick(kThreeTurns);
  EXPECT_FALSE(node_of(fleet, 3).rate->stale);
  fleet.tick(kThreeTurns + kMs);
  EXPECT_TRUE(node_of(fleet, 3).rate->stale);
  EXPECT_FALSE(node_of(fleet, 3).tendons.at(1).stale);
  EXPECT_TRUE(node_of(fleet, 3).status == std::nullopt);
  fleet.see(sender.heartbeat(2 * kThreeTurns - kMs));
  fleet.tick(2 * kThreeTurns);
  EXPECT_FALSE(node_of(fleet, 3).tendons.at(1).stale);
  fleet.tick(2 * kThreeTurns + kMs);
  EXPECT_TRUE(node_of(fleet, 3).tendons.at(1).stale);
}

TEST(Fleet, ShowsThatANodeVanishedAndCameBack) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.damage(kS, 1));
  fleet.see(sender.emergency(kS, {.code = protocol::EmergencyCode::overload}));
  fleet.tick(4 * kS);
  EXPECT_FALSE(node_of(fleet, 3).vanished);
  fleet.tick(4 * kS + 1);
  EXPECT_TRUE(node_of(fleet, 3).vanished);
  EXPECT_TRUE(node_of(fleet, 3).emergency->stale);
  EXPECT_EQ(node_of(fleet, 3).events.back().kind, EventKind::vanished);
  EXPECT_EQ(node_of(fleet, 3).events.back().time_ns, 4 * kS);
  fleet.see(sender.heartbeat(9 * kS));
  EXPECT_FALSE(node_of(fleet, 3).vanished);
  EXPECT_EQ(node_of(fleet, 3).events.back().kind, EventKind::back);
}

TEST(Fleet, DamagedFramesAreNoSignOfLife) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.damage(0, 1));
  for (int i = 1; i < 40; ++i) {
    SeenFrame frame = sender.damage(i * 100 * kMs, 1);
    frame.frame.data[3] ^= std::byte{1};
    fleet.see(frame);
  }
  EXPECT_TRUE(node_of(fleet, 3).vanished);
  EXPECT_EQ(event_texts(node_of(fleet, 3), EventKind::integrity).size(), 1u);
}

TEST(Fleet, NoNodeVanishesFromABusThatCannotBeHeard) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.damage(0, 1));
  fleet.source_is(FrameSource::State::lost, "can0 is down");
  fleet.tick(60 * kS);
  EXPECT_TRUE(fleet.view().source_lost);
  EXPECT_EQ(fleet.view().source, "can0 is down");
  EXPECT_FALSE(node_of(fleet, 3).vanished);
  EXPECT_TRUE(node_of(fleet, 3).status->stale);
  fleet.source_is(FrameSource::State::running, "can0");
  fleet.tick(63 * kS);
  EXPECT_FALSE(node_of(fleet, 3).vanished);
  fleet.tick(63 * kS + 1);
  EXPECT_TRUE(node_of(fleet, 3).vanished);
}

/// What two controllers report in turn, the first counter of the second one so far ahead.
void hear_two(Fleet& fleet, int ahead, protocol::LifeState other_state, std::uint32_t other_ppb) {
  constexpr int kTurns = 20;
  Sender one(3);
  Sender other(3);
  for (int i = 0; i < ahead; ++i) {
    (void)other.damage(0, 0);
  }
  for (int i = 0; i < kTurns; ++i) {
    fleet.see(one.damage(i * 100 * kMs, 1'000));
    fleet.see(
        other.status(i * 100 * kMs + 37 * kMs, {.state = other_state, .damage_ppb = other_ppb}));
  }
}

TEST(Fleet, TwoControllersWithOneNodeIdAreTheGravestState) {
  for (int ahead = 0; ahead < 16; ++ahead) {
    Fleet fleet;
    hear_two(fleet, ahead, protocol::LifeState::worn, 1'500'000'000);
    const NodeView& node = node_of(fleet, 3);
    EXPECT_TRUE(node.two_controllers) << ahead;
    EXPECT_EQ(node.life_state(), protocol::LifeState::worn) << ahead;
    EXPECT_EQ(node.highest_damage_ppb, 1'500'000'000u) << ahead;
    EXPECT_FALSE(node.status->stale) << ahead;
    EXPECT_EQ(event_texts(node, EventKind::two_controllers),
              std::vector<std::string>{"two controllers have this node id"})
        << ahead;
    EXPECT_TRUE(event_texts(node, EventKind::epoch).empty()) << ahead;
  }
}

TEST(Fleet, TwoControllersThatTellTheSameAreTwo) {
  for (int ahead = 0; ahead < 16; ++ahead) {
    Fleet fleet;
    hear_two(fleet, ahead, protocol::LifeState::normal, 1'000);
    EXPECT_TRUE(node_of(fleet, 3).two_controllers) << ahead;
  }
}

TEST(Fleet, DoubledLateAndLostFramesAreOfOneController) {
  Fleet fleet;
  Sender sender(3);
  std::vector<SeenFrame> frames;
  for (int i = 0; i < 400; ++i) {
    frames.push_back(sender.damage(0, 1'000u + static_cast<std::uint32_t>(i / 7)));
  }
  std::int64_t time_ns = 0;
  const auto see = [&](std::size_t i) {
    frames[i].time_ns = time_ns += 40 * kMs;
    fleet.see(frames[i]);
  };
  for (std::size_t i = 0; i + 4 < frames.size(); i += 4) {
    see(i + 1);
    see(i);
    if (i % 3 != 0) {
      see(i + 2);
      frames[i + 2].time_ns += kMs;
      fleet.see(frames[i + 2]);
    }
    see(i + 3);
    if (i % 40 == 0) {
      sender = Sender(3);
      fleet.see(sender.heartbeat(time_ns, protocol::NmtState::boot_up));
    }
  }
  EXPECT_FALSE(node_of(fleet, 3).two_controllers);
}

TEST(Fleet, ABootBeginsTheCountersAnew) {
  Fleet fleet;
  Sender before(3);
  for (int i = 0; i < 8; ++i) {
    fleet.see(before.emergency(i * 100 * kMs, {.code = protocol::EmergencyCode::overload}));
  }
  Sender after(3);
  fleet.see(after.heartbeat(kS, protocol::NmtState::boot_up));
  fleet.see(after.emergency(kS, {.code = protocol::EmergencyCode::sensor}));
  EXPECT_EQ(node_of(fleet, 3).emergency->value.code, protocol::EmergencyCode::sensor);
  EXPECT_EQ(node_of(fleet, 3).streams[kEmergency].wrong_sequence, 0u);
  EXPECT_EQ(event_texts(node_of(fleet, 3), EventKind::boot).size(), 1u);
}

TEST(Fleet, AnEmergencyAfterManyLostOnesIsShown) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.emergency(0, {.code = protocol::EmergencyCode::overload}));
  for (int i = 0; i < 5; ++i) {
    (void)sender.emergency(0, {});
  }
  fleet.see(sender.emergency(60 * kS, {.code = protocol::EmergencyCode::storage}));
  EXPECT_EQ(node_of(fleet, 3).emergency->value.code, protocol::EmergencyCode::storage);
  EXPECT_EQ(node_of(fleet, 3).streams[kEmergency].silences, 1u);
}

TEST(Fleet, ALostEmergencyIsCountedHoweverLateTheNextOne) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.emergency(0, {}));
  (void)sender.emergency(0, {});
  fleet.see(sender.emergency(60 * kS, {}));
  EXPECT_EQ(node_of(fleet, 3).streams[kEmergency].lost, 1u);
}

// Page 15 is none of the schema; its CRC is right.
TEST(Fleet, CountsWhatTheSchemaDoesNotHave) {
  Fleet fleet;
  Sender sender(3);
  hal::CanFrame frame = protocol::encode(3, protocol::detail::Identity{});
  frame.data[1] = std::byte{0xf0};
  protocol::e2e::Protector(protocol::e2e::stream_of<protocol::detail::Identity>(3)).protect(frame);
  fleet.see(test::seen(0, frame));
  EXPECT_EQ(node_of(fleet, 3).streams[kDetail].malformed, 1u);
  EXPECT_EQ(node_of(fleet, 3).integrity_failures(), 1u);
}

TEST(Fleet, CountsIntervalsInTwentiethsOfTheCycle) {
  Fleet fleet;
  Sender sender(3);
  for (const std::int64_t at_ms : {0, 100, 200, 304, 310, 900}) {
    fleet.see(sender.damage(at_ms * kMs, 1));
  }
  for (const std::int64_t at_ms : {0, 1000, 2049, 3149}) {
    fleet.see(sender.heartbeat(kS + at_ms * kMs));
  }
  const auto& heartbeats = node_of(fleet, 3).streams[kHeartbeat].intervals;
  EXPECT_EQ(heartbeats[20], 2u);  // 1000, 1049
  EXPECT_EQ(heartbeats[22], 1u);  // 1100
  const auto& intervals = node_of(fleet, 3).streams[kStatus].intervals;
  EXPECT_EQ(intervals[20], 3u);  // 100, 100, 104
  EXPECT_EQ(intervals[1], 1u);   // 6
  EXPECT_EQ(intervals[39], 1u);  // 590
}

TEST(Fleet, PutsBinsIntoTheirPlace) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.page(0, protocol::detail::RainflowBin{
                               .tendon = 2, .range_class = 3, .mean_class = 5, .cycles = 77}));
  EXPECT_EQ(node_of(fleet, 3).bins.at(64 * 2 + 8 * 3 + 5).value.cycles, 77u);
}

TEST(Fleet, FollowsTheStateOfTheBus) {
  Fleet fleet;
  SeenFrame frame;
  frame.error = BusError{.bus_off = true};
  fleet.see(frame);
  EXPECT_TRUE(fleet.view().bus_off);
  frame.error = BusError{.receive_overflow = true};
  fleet.see(frame);
  EXPECT_TRUE(fleet.view().bus_off);
  frame.error = BusError{.restarted = true};
  fleet.see(frame);
  EXPECT_FALSE(fleet.view().bus_off);
  EXPECT_EQ(fleet.view().error_frames, 3u);
  EXPECT_EQ(fleet.view().receive_overflows, 1u);
  EXPECT_EQ(fleet.view().frames, 0u);
  frame.error = BusError{.bus_off = true};
  fleet.see(frame);
  fleet.source_is(FrameSource::State::lost, "can0 is down");
  EXPECT_TRUE(fleet.view().bus_off);
  fleet.source_is(FrameSource::State::running, "can0");
  EXPECT_FALSE(fleet.view().bus_off);
}

TEST(Fleet, NeverDecodesRemoteRequestsAndFlexibleFrames) {
  Fleet fleet;
  Sender sender(3);
  SeenFrame remote = sender.damage(0, 1);
  remote.remote_request = true;
  fleet.see(remote);
  SeenFrame flexible = sender.damage(0, 1);
  flexible.flexible_data_rate = true;
  fleet.see(flexible);
  EXPECT_TRUE(fleet.view().nodes.empty());
  EXPECT_EQ(fleet.view().foreign_frames, 2u);
}

TEST(Fleet, ACommandMakesNoNode) {
  Fleet fleet;
  hal::CanFrame frame = protocol::encode(7, protocol::Command{});
  protocol::e2e::Protector(protocol::e2e::stream_of<protocol::Command>(7)).protect(frame);
  fleet.see(test::seen(0, frame));
  EXPECT_TRUE(fleet.view().nodes.empty());
}

}  // namespace
}  // namespace host_sim::monitor
