#include "host_sim/monitor/terminal/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace host_sim::monitor {
namespace {

constexpr std::int64_t kS = 1'000'000'000;

NodeView node_of(protocol::LifeState state, std::uint32_t damage_ppb) {
  NodeView node;
  node.node = 5;
  node.heartbeat = {protocol::NmtState::operational, 9 * kS};
  node.status = {{.state = state, .damage_ppb = damage_ppb, .storage_ok = true, .sensor_ok = true},
                 10 * kS};
  node.highest_damage_ppb = damage_ppb;
  node.rate = {{.ppb_per_h = 1'234}, 10 * kS};
  node.remaining = {{.b10_dh = 123, .b50_dh = 200, .b90_dh = 456}, 10 * kS};
  node.break_risk = {{.horizon_h = 8, .within_horizon = 26}, 10 * kS};
  return node;
}

FleetView fleet_of(const NodeView& node) {
  FleetView view;
  view.now_ns = 10 * kS;
  view.source = "can0";
  view.nodes[5] = node;
  return view;
}

std::string row_of(const NodeView& node, const TableStyle& style = {}) {
  return table_of(fleet_of(node), style).back();
}

TEST(Table, ShowsANodeInARow) {
  const auto lines = table_of(fleet_of(node_of(protocol::LifeState::inspect, 121'000'000)), {});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "can0  0 frames  0/s  load 0.0 %  1 node");
  EXPECT_EQ(lines[1],
            "NODE  STATE    DAMAGE %  LEFT B10 - B90  BREAK RISK     RATE %/h   HEARTBEAT  FAILED  "
            "LOST  NOTES");
  EXPECT_EQ(
      lines[2],
      "5     inspect  12.1      12.3 - 45.6 h   0.65 % in 8 h  0.0001234  1.0 s      0       0");
}

TEST(Table, ARateThatIsNotKnownYetIsNoNumber) {
  NodeView node = node_of(protocol::LifeState::inspect, 121'000'000);
  node.rate->value.ppb_per_h = 0xffff'ffff;
  EXPECT_NE(row_of(node).find("12.3 - 45.6 h   0.65 % in 8 h  unknown   1.0 s"), std::string::npos)
      << row_of(node);
}

// 2^32 - 1 ppb is the end of the range of the damage, one less that of the rate.
TEST(Table, TheEndOfARangeIsNoExactNumber) {
  NodeView node = node_of(protocol::LifeState::worn, 0xffff'ffff);
  node.rate->value.ppb_per_h = 0xffff'fffe;
  EXPECT_NE(row_of(node).find("  >=429.4967295  12.3 - 45.6 h   0.65 % in 8 h  >=429.4967294  "),
            std::string::npos)
      << row_of(node);
  node.highest_damage_ppb -= 1;
  node.rate->value.ppb_per_h -= 1;
  EXPECT_EQ(row_of(node).find(">="), std::string::npos) << row_of(node);
}

TEST(Table, TwoControllersAreTheGravestState) {
  NodeView node = node_of(protocol::LifeState::normal, 121'000'000);
  node.two_controllers = true;
  EXPECT_NE(row_of(node).find("TWO CONTROLLERS (normal)"), std::string::npos) << row_of(node);
  EXPECT_NE(row_of(node).find("two controllers have this node id"), std::string::npos);
}

TEST(Table, MarksWhatIsStale) {
  NodeView node = node_of(protocol::LifeState::inspect, 121'000'000);
  node.status->stale = true;
  EXPECT_NE(row_of(node).find("inspect STALE  12.1 STALE  12.3 - 45.6 h"), std::string::npos);
  node.remaining->stale = true;
  node.rate->stale = true;
  node.heartbeat->stale = true;
  const std::string row = row_of(node, {.width = 0, .colours = true});
  EXPECT_NE(row.find("\x1b[90minspect STALE\x1b[0m"), std::string::npos);
  EXPECT_NE(row.find("\x1b[90m12.1 STALE\x1b[0m"), std::string::npos);
  EXPECT_NE(row.find("\x1b[90m12.3 - 45.6 h STALE\x1b[0m"), std::string::npos);
  EXPECT_NE(row.find("\x1b[90m0.0001234 STALE\x1b[0m"), std::string::npos);
  EXPECT_NE(row.find("\x1b[90m1.0 s STALE\x1b[0m"), std::string::npos);
}

TEST(Table, NeverPartsAValueFromItsMark) {
  NodeView node = node_of(protocol::LifeState::inspect, 121'000'000);
  node.status->stale = node.remaining->stale = node.rate->stale = node.heartbeat->stale = true;
  for (std::size_t width = 1; width < 140; ++width) {
    const std::string row = row_of(node, {.width = width, .colours = false});
    EXPECT_EQ(row.find("12.1") == std::string::npos, row.find("12.1 STALE") == std::string::npos)
        << width;
    EXPECT_EQ(row.find("45.6") == std::string::npos, row.find("45.6 h STALE") == std::string::npos)
        << width;
    EXPECT_LE(row.size(), std::max<std::size_t>(width, 4)) << width;
  }
}

using Lines = std::vector<std::string>;

Lines lines_at(std::size_t width, const NodeView& node) {
  Lines lines = table_of(fleet_of(node), {.width = width, .colours = false});
  lines.erase(lines.begin());
  return lines;
}

TEST(Table, LeavesOutTheLeastImportantColumnsFirstAndNamesThem) {
  const NodeView node = node_of(protocol::LifeState::normal, 1);
  EXPECT_EQ(lines_at(80, node),
            (Lines{"Too narrow for LEFT B10 - B90, RATE %/h",
                   "NODE  STATE   DAMAGE %   BREAK RISK     HEARTBEAT  FAILED  LOST  NOTES",
                   "5     normal  0.0000001  0.65 % in 8 h  1.0 s      0       0"}));
  EXPECT_EQ(lines_at(40, node),
            (Lines{"Too narrow for LEFT B10 - B90,", "BREAK RISK, RATE %/h, HEARTBEAT, NOTES",
                   "NODE  STATE   DAMAGE %   FAILED  LOST", "5     normal  0.0000001  0       0"}));
  EXPECT_EQ(lines_at(104, node).size(), 2u);
}

NodeView troubled_node() {
  NodeView node = node_of(protocol::LifeState::inspect, 121'000'000);
  node.emergency = {{.code = protocol::EmergencyCode::overload}, 0};
  node.status->value.locked = true;
  node.status->value.sensor_ok = false;
  return node;
}

TEST(Table, NotesAreCutBeforeTheyAreLeftOut) {
  NodeView node = troubled_node();
  EXPECT_EQ(lines_at(80, node),
            (Lines{"Too narrow for LEFT B10 - B90, RATE %/h",
                   "NODE  STATE    DAMAGE %  BREAK RISK     HEARTBEAT  FAILED  LOST  NOTES",
                   "5     inspect  12.1      0.65 % in 8 h  1.0 s      0       0     overload, "
                   "lo..."}));
  EXPECT_EQ(lines_at(51, node).back(), "5     inspect  12.1      0       0     overload,...");
  EXPECT_EQ(lines_at(50, node).back(), "5     inspect  12.1      0       0");
  EXPECT_EQ(lines_at(121, node).back().substr(92), "overload, locked, sensor f...");
  EXPECT_EQ(lines_at(122, node).back().substr(92), "overload, locked, sensor fault");
}

TEST(Table, ACutNoteKeepsItsMark) {
  NodeView node = troubled_node();
  node.status->stale = true;
  for (std::size_t width = 59; width < 150; ++width) {
    const std::string row = lines_at(width, node).back();
    EXPECT_TRUE(row.ends_with("fault STALE") || row.ends_with("... STALE")) << width << row;
  }
}

TEST(Table, TheGravestNodesComeFirst) {
  FleetView view;
  for (const auto number :
       {protocol::Node{1}, protocol::Node{2}, protocol::Node{3}, protocol::Node{9}}) {
    view.nodes[number] = node_of(protocol::LifeState::normal, 0);
    view.nodes[number].node = number;
  }
  view.nodes[9].status->value.broken = true;
  view.nodes[3].gravest_state = protocol::LifeState::worn;
  std::string numbers;
  for (const std::string& line : table_of(view, {})) {
    numbers += line.substr(0, 1);
  }
  EXPECT_EQ(numbers.substr(2), "9312");
}

TEST(Table, ColoursTheState) {
  const TableStyle style{.width = 0, .colours = true};
  EXPECT_NE(row_of(node_of(protocol::LifeState::normal, 0), style).find("\x1b[32mnormal\x1b[0m"),
            std::string::npos);
  EXPECT_NE(row_of(node_of(protocol::LifeState::worn, 0), style).find("\x1b[1;37;41mworn\x1b[0m"),
            std::string::npos);
  EXPECT_EQ(row_of(node_of(protocol::LifeState::worn, 0)).find('\x1b'), std::string::npos);
}

TEST(Table, SaysWhatIsTheMatter) {
  NodeView node = node_of(protocol::LifeState::normal, 0);
  node.vanished = true;
  EXPECT_NE(row_of(node).find("normal VANISHED"), std::string::npos);
  node = node_of(protocol::LifeState::normal, 0);
  node.emergency = {{.code = protocol::EmergencyCode::overload}, 0};
  node.status->value.locked = true;
  node.status->value.sensor_ok = false;
  node.streams.push_back({});
  node.streams[0].damaged = 7;
  node.streams[0].lost = 3;
  EXPECT_NE(row_of(node).find("7       3     overload, locked, sensor fault"), std::string::npos);
  node.status->value.broken = true;
  node.status->value.slack = true;
  EXPECT_NE(row_of(node).find("overload, broken, slack, locked"), std::string::npos);
  FleetView view = fleet_of(node);
  view.bus_off = true;
  view.source_lost = true;
  view.source = "can0 is down";
  const auto lines = table_of(view, {});
  EXPECT_EQ(lines[1], "BUS LOST: can0 is down");
  EXPECT_EQ(lines[2], "BUS OFF");
}

TEST(Table, TellsRemainingLifeThatIsNotKnown) {
  NodeView node = node_of(protocol::LifeState::normal, 0);
  node.remaining->value = {};
  EXPECT_NE(row_of(node).find("unknown"), std::string::npos);
  node.remaining->value = {.b10_dh = 10, .b50_dh = 65'000, .b90_dh = 65'533};
  EXPECT_NE(row_of(node).find("1.0 - 6553.3 h"), std::string::npos);
}

TEST(Table, RemainingLifeAtTheEndOfItsFieldIsThatOrMore) {
  NodeView node = node_of(protocol::LifeState::normal, 0);
  node.remaining->value = {.b10_dh = 10, .b50_dh = 0xfffe, .b90_dh = 0xfffe};
  EXPECT_NE(row_of(node).find("1.0 - >=6553.4 h"), std::string::npos);
  node.remaining->value.b10_dh = 0xfffe;
  EXPECT_NE(row_of(node).find(">=6553.4 - >=6553.4 h"), std::string::npos);
}

TEST(Table, ABreakRiskThatIsNotKnownYetIsNoNumber) {
  NodeView node = node_of(protocol::LifeState::normal, 0);
  node.break_risk->value.within_horizon = 0xfff;
  EXPECT_NE(row_of(node).find("12.3 - 45.6 h   unknown     0.0001234"), std::string::npos)
      << row_of(node);
  node.break_risk->stale = true;
  EXPECT_NE(row_of(node).find("unknown STALE"), std::string::npos);
}

TEST(Table, NotesWhatIsAdvisedForALoadThatDoesNotLast) {
  using protocol::AdviceState;
  NodeView node = node_of(protocol::LifeState::normal, 0);
  node.advice[0] = {{.tendon = 0, .state = AdviceState::off}, 10 * kS};
  node.advice[1] = {
      {.tendon = 1, .state = AdviceState::no_limit, .highest_tension = 2000, .pace = 4000},
      10 * kS};
  EXPECT_EQ(row_of(node).find("tendon"), std::string::npos) << row_of(node);
  node.advice[2] = {
      {.tendon = 2, .state = AdviceState::limited, .highest_tension = 1005, .pace = 2591}, 10 * kS};
  node.advice[3] = {
      {.tendon = 3, .state = AdviceState::unreachable, .highest_tension = 0, .pace = 0}, 10 * kS};
  EXPECT_NE(row_of(node).find("tendon 2: at most 25.12 % tension or 64.78 % pace, tendon 3: no "
                              "tension lasts"),
            std::string::npos)
      << row_of(node);
  node.advice[2].stale = true;
  EXPECT_EQ(row_of(node).find("tendon 2"), std::string::npos) << row_of(node);
}

TEST(Table, ANodeWithoutAStatusHasNoDamage) {
  NodeView node;
  node.node = 5;
  EXPECT_EQ(row_of(node).substr(0, 20), "5     no status  -  ");
}

}  // namespace
}  // namespace host_sim::monitor
