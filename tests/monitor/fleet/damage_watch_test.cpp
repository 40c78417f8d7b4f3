#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/monitor/fleet/fleet.hpp"
#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor {
namespace {

using test::event_texts;
using test::kMs;
using test::kS;
using test::Sender;

/// Node 3, which reports its damage every 100 ms, and its last record where it is asked to.
class Reports {
 public:
  void damage(std::uint32_t damage_ppb, int times = 1,
              protocol::LifeState state = protocol::LifeState::normal) {
    for (int i = 0; i < times; ++i) {
      fleet.see(sender.status(now_ns += 100 * kMs, {.state = state, .damage_ppb = damage_ppb}));
    }
  }
  void record(std::uint32_t sequence, std::uint32_t unsaved_ppb) {
    fleet.see(sender.page(
        now_ns += kMs,
        protocol::detail::Storage{.sequence = sequence, .worst_unsaved_ppb = unsaved_ppb}));
  }
  void restart() {
    sender = Sender(3);
    fleet.see(sender.heartbeat(now_ns += kS, protocol::NmtState::boot_up));
  }
  [[nodiscard]] const NodeView& node() const { return fleet.view().nodes.at(3); }
  [[nodiscard]] std::uint32_t shown_ppb() const { return node().highest_damage_ppb; }
  [[nodiscard]] std::vector<std::string> epochs() const {
    return event_texts(node(), EventKind::epoch);
  }

  Fleet fleet;
  Sender sender{3};
  std::int64_t now_ns = 0;
};

TEST(Fleet, DamageFallsWithANewEpochOnly) {
  Reports reports;
  reports.damage(121'000'000, 2);
  reports.record(7, 1'000);
  reports.damage(121'000'000);
  reports.damage(0);
  reports.damage(10);
  reports.record(8, 1'000);
  reports.damage(20, 2);
  EXPECT_EQ(reports.shown_ppb(), 121'000'000u);
  reports.damage(20);
  EXPECT_EQ(reports.shown_ppb(), 20u);
  EXPECT_EQ(reports.epochs(),
            std::vector<std::string>{"epoch opened: damage fell from 12.1 to 0.000002 %"});
}

TEST(Fleet, APowerCutIsNoNewEpoch) {
  Reports reports;
  reports.damage(5'000);
  reports.record(7, 1'000);
  reports.damage(5'000);
  reports.restart();
  for (std::uint32_t sequence = 7; sequence < 20; ++sequence) {
    reports.damage(4'000, 9);
    reports.record(sequence, 0);
  }
  EXPECT_EQ(reports.shown_ppb(), 5'000u);
  reports.restart();
  reports.damage(3'999);
  reports.record(20, 0);
  reports.damage(3'999, 3);
  EXPECT_EQ(reports.shown_ppb(), 3'999u);
}

// 24 bits, all ones: a power cut may lose more.
TEST(Fleet, TheEndOfARangeIsNoBound) {
  Reports reports;
  reports.damage(500'000'000);
  reports.record(7, 0xff'ffff);
  reports.damage(500'000'000);
  reports.restart();
  for (std::uint32_t sequence = 7; sequence < 20; ++sequence) {
    reports.damage(400'000'000, 9);
    reports.record(sequence, 0);
  }
  EXPECT_EQ(reports.shown_ppb(), 500'000'000u);
  EXPECT_TRUE(reports.epochs().empty());
}

TEST(Fleet, ANewWireIsSeenHoweverLittleTheOldOneHadSuffered) {
  Reports reports;
  reports.record(7, 1'000);
  reports.damage(500, 9);
  reports.record(7, 1'000);
  reports.damage(500, 5);
  reports.record(8, 1'000);  // before a status is of the new wire
  reports.damage(0, 9);
  EXPECT_EQ(reports.shown_ppb(), 500u);
  reports.record(8, 1'000);
  reports.damage(0, 9);
  EXPECT_EQ(reports.shown_ppb(), 0u);
  EXPECT_EQ(reports.epochs().size(), 1u);
}

// The log that is played again has records of the past.
TEST(Fleet, AnOldLogThatIsPlayedAgainIsNoNewEpoch) {
  Reports reports;
  reports.damage(700'000'000, 3, protocol::LifeState::worn);
  reports.record(90, 1'000);
  reports.damage(700'000'000, 3, protocol::LifeState::worn);
  reports.sender = Sender(3);
  reports.now_ns += kS;
  for (std::uint32_t sequence = 50; sequence < 60; ++sequence) {
    reports.damage(100'000'000 + sequence, 9);
    reports.record(sequence, 1'000);
  }
  EXPECT_EQ(reports.shown_ppb(), 700'000'000u);
  EXPECT_EQ(reports.node().life_state(), protocol::LifeState::worn);
  EXPECT_TRUE(reports.epochs().empty());
}

// The counters of the old log go on where those of the node stopped, and the reports of the node
// are lost meanwhile, not its record. That it is of another speaker shows in the next page alone:
// it has the same counter.
TEST(Fleet, ARecordOfTheNodeAmongTheReportsOfAnOldLogIsNoNewEpoch) {
  Reports reports;
  Sender old_log(3);
  const auto old_status = [&](std::int64_t time_ns) {
    return old_log.damage(time_ns, 100'000'000);
  };
  const auto old_record = [&](std::int64_t time_ns) {
    return old_log.page(time_ns,
                        protocol::detail::Storage{.sequence = 50, .worst_unsaved_ppb = 1'000});
  };
  reports.damage(700'000'000, 2);
  reports.record(90, 1'000);
  reports.damage(700'000'000);
  for (int i = 0; i < 3; ++i) {
    (void)old_status(0);
  }
  (void)old_record(0);
  reports.fleet.see(old_status(reports.now_ns += 100 * kMs));
  reports.record(91, 1'000);
  reports.fleet.see(old_record(reports.now_ns += kMs));
  for (int i = 0; i < 3; ++i) {
    reports.fleet.see(old_status(reports.now_ns += 100 * kMs));
  }
  EXPECT_EQ(reports.node().streams.at(1).good, 7u);  // the reports of both
  EXPECT_EQ(reports.shown_ppb(), 700'000'000u);
  EXPECT_TRUE(reports.epochs().empty());
}

TEST(Fleet, ALostRecordIsNoNewEpoch) {
  Reports reports;
  reports.damage(700'000'000);
  reports.record(90, 1'000);
  reports.damage(700'000'000);
  reports.restart();
  for (std::uint32_t sequence = 91; sequence < 99; ++sequence) {
    for (int i = 0; i < 9; ++i) {
      reports.fleet.see(reports.sender.status(reports.now_ns += 100 * kMs,
                                              {.state = protocol::LifeState::normal,
                                               .damage_ppb = 5,
                                               .quality = protocol::Quality::untrusted}));
    }
    reports.record(sequence, 0);
  }
  EXPECT_EQ(reports.shown_ppb(), 700'000'000u);
}

// A silence of more than 0.3 s begins the counters anew.
TEST(Fleet, NoStateFallsWithoutANewEpoch) {
  Reports reports;
  reports.damage(900'000'000, 1, protocol::LifeState::worn);
  reports.now_ns += 400 * kMs;
  reports.damage(100'000'000, 1, protocol::LifeState::normal);
  EXPECT_EQ(reports.node().life_state(), protocol::LifeState::worn);
  EXPECT_EQ(event_texts(reports.node(), EventKind::state), std::vector<std::string>{"worn"});
  reports.damage(900'000'000, 1, protocol::LifeState::unknown);
  EXPECT_EQ(reports.node().life_state(), protocol::LifeState::worn);
}

TEST(Fleet, TheDamageOfATendonFallsWithANewEpochOnly) {
  Reports reports;
  const auto tendon = [&](std::uint32_t damage_ppb, protocol::LifeState state) {
    reports.fleet.see(reports.sender.page(
        reports.now_ns += 100 * kMs,
        protocol::detail::TendonDamage{.tendon = 2, .damage_ppb = damage_ppb, .state = state}));
  };
  const auto shown = [&] { return reports.node().tendons.at(2).value; };
  reports.damage(600'000'000);
  tendon(600'000'000, protocol::LifeState::replace);
  reports.record(7, 1'000);
  tendon(600'000'000, protocol::LifeState::replace);
  tendon(0, protocol::LifeState::normal);
  EXPECT_EQ(shown().damage_ppb, 600'000'000u);
  EXPECT_EQ(shown().state, protocol::LifeState::replace);
  reports.record(8, 1'000);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(shown().damage_ppb, 600'000'000u);
    tendon(5, protocol::LifeState::normal);
  }
  EXPECT_EQ(shown().damage_ppb, 5u);
  EXPECT_EQ(shown().state, protocol::LifeState::normal);
}

/// Tendon 2 of two is replaced at 60 %, and of 5,000 cycles of all 1,700 are left.
std::vector<WireLife> lives_after_replacement(bool with_start) {
  Reports reports;
  const auto page = [&](const auto& content) {
    reports.fleet.see(reports.sender.page(reports.now_ns += 100 * kMs, content));
  };
  const auto tendon = [&](std::uint32_t damage_ppb) {
    page(protocol::detail::TendonDamage{
        .tendon = 2, .damage_ppb = damage_ppb, .state = protocol::LifeState::normal});
  };
  reports.damage(600'000'000);
  tendon(600'000'000);
  reports.record(7, 1'000);
  tendon(600'000'000);
  page(protocol::detail::Cycles{.cycles = 5000});
  if (with_start) {
    reports.fleet.see(reports.sender.heartbeat(reports.now_ns, protocol::NmtState::boot_up));
  }
  tendon(0);
  page(protocol::detail::Cycles{.cycles = 1700});
  reports.record(8, 1'000);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(reports.node().wire_lives.empty());
    tendon(5);
  }
  return reports.node().wire_lives;
}

TEST(Fleet, AWireThatIsReplacedWholeHasItsLife) {
  const std::vector<WireLife> lives = lives_after_replacement(false);
  ASSERT_EQ(lives.size(), 1u);
  EXPECT_EQ(lives[0].tendon, 2);
  EXPECT_FALSE(lives[0].broken);
  EXPECT_EQ(lives[0].damage_ppb, 600'000'000u);
  EXPECT_EQ(lives[0].cycles, 3300);
}

TEST(Fleet, WhatCyclesFallByOverAStartIsNoLife) {
  const std::vector<WireLife> lives = lives_after_replacement(true);
  ASSERT_EQ(lives.size(), 1u);
  EXPECT_FALSE(lives[0].cycles);
}

TEST(Fleet, OneLateStatusAmongOthersIsNoNewEpoch) {
  Fleet fleet;
  Sender sender(3);
  fleet.see(sender.damage(0, 500));
  for (int i = 1; i < 30; ++i) {
    fleet.see(sender.damage(i * 100 * kMs, i % 3 == 0 ? 500u : 400u));
  }
  EXPECT_EQ(fleet.view().nodes.at(3).highest_damage_ppb, 500u);
  EXPECT_TRUE(event_texts(fleet.view().nodes.at(3), EventKind::epoch).empty());
}

// Whatever becomes of the frames of a node on their way, no damage is shown that no genuine frame
// reported. Damaged frames have up to three wrong bits of data, which the protection finds for
// certain, or wrong bits of their identifier.

struct Traffic {
  std::vector<SeenFrame> frames;
  std::set<std::uint32_t> damages_ppb{0};
  std::set<std::uint32_t> tendon_damages_ppb;
};

Traffic genuine_traffic() {
  Traffic traffic;
  Sender sender(static_cast<protocol::Node>(*rc::gen::inRange(1, 128)));
  auto damage_ppb = *rc::gen::inRange<std::uint32_t>(0, 2'000'000'000);
  const int count = *rc::gen::inRange(1, 120);
  for (int i = 0; i < count; ++i) {
    const std::int64_t time_ns = i * 100 * kMs;
    damage_ppb = *rc::gen::inRange(0, 40) == 0
                     ? 0
                     : damage_ppb + *rc::gen::inRange<std::uint32_t>(0, 1'000'000);
    traffic.damages_ppb.insert(damage_ppb);
    traffic.frames.push_back(sender.damage(time_ns, damage_ppb));
    if (i % 9 == 3) {
      traffic.tendon_damages_ppb.insert(damage_ppb);
      traffic.frames.push_back(sender.page(
          time_ns, protocol::detail::TendonDamage{.tendon = 1, .damage_ppb = damage_ppb}));
    }
    if (i % 10 == 0) {
      traffic.frames.push_back(sender.heartbeat(time_ns));
      const std::uint32_t damage_ppm = damage_ppb / 1000;
      traffic.damages_ppb.insert(damage_ppm * 1000);
      traffic.frames.push_back(sender.emergency(time_ns, {.code = protocol::EmergencyCode::overload,
                                                          .error_register = 0,
                                                          .damage_ppm = damage_ppm}));
    }
  }
  return traffic;
}

void spoil(SeenFrame& seen) {
  if (*rc::gen::inRange(0, 4) == 0) {
    seen.frame.id ^= *rc::gen::inRange<std::uint32_t>(1, 0x800);
    return;
  }
  if (seen.frame.length < 8) {
    return;  // a heartbeat has no damage
  }
  const auto bits = *rc::gen::unique<std::vector<int>>(
      static_cast<std::size_t>(*rc::gen::inRange(1, 4)), rc::gen::inRange(0, 64));
  for (const int bit : bits) {
    seen.frame.data[static_cast<std::size_t>(bit / 8)] ^= std::byte{1} << (bit % 8);
  }
}

/// What arrives of `sent`, at the times at which it arrives.
std::vector<SeenFrame> spoiled(const std::vector<SeenFrame>& sent) {
  std::vector<SeenFrame> arrived;
  for (const SeenFrame& frame : sent) {
    switch (*rc::gen::inRange(0, 8)) {
      case 0:
        break;
      case 1:
        arrived.insert(arrived.end(), 2, frame);
        break;
      case 2:
        arrived.push_back(frame);
        spoil(arrived.back());
        break;
      default:
        arrived.push_back(frame);
    }
    if (arrived.size() >= 2 && *rc::gen::inRange(0, 6) == 0) {
      const auto back =
          *rc::gen::inRange<std::size_t>(2, std::min<std::size_t>(arrived.size(), 12) + 1);
      std::swap(arrived.back(), arrived[arrived.size() - back]);
    }
  }
  std::int64_t time_ns = 0;
  for (SeenFrame& frame : arrived) {
    time_ns += *rc::gen::element<std::int64_t>(0, 10, 50, 100, 900) * kMs;
    frame.time_ns = time_ns;
  }
  return arrived;
}

RC_GTEST_PROP(FleetProperty, ShowsNoDamageThatNoGenuineFrameTold, ()) {
  const Traffic traffic = genuine_traffic();
  Fleet fleet;
  for (const SeenFrame& frame : spoiled(traffic.frames)) {
    fleet.see(frame);
    for (const auto& [number, node] : fleet.view().nodes) {
      RC_ASSERT(traffic.damages_ppb.contains(node.highest_damage_ppb));
      if (node.status) {
        RC_ASSERT(traffic.damages_ppb.contains(node.status->value.damage_ppb));
      }
      for (const auto& [tendon, value] : node.tendons) {
        RC_ASSERT(tendon == 1);
        RC_ASSERT(traffic.tendon_damages_ppb.contains(value.value.damage_ppb));
      }
      for (const DamagePoint& point : node.curve) {
        RC_ASSERT(traffic.damages_ppb.contains(point.damage_ppb));
      }
    }
  }
}

}  // namespace
}  // namespace host_sim::monitor
