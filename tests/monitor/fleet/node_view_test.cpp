#include "host_sim/monitor/fleet/node_view.hpp"

#include <gtest/gtest.h>

namespace host_sim::monitor {
namespace {

TEST(DamageCurve, StaysWithinItsLimitForADay) {
  NodeView view;
  DamageCurve curve;
  constexpr std::int64_t kPoints = 24 * 3600 * 10;
  for (std::int64_t i = 0; i < kPoints; ++i) {
    curve.add(view, {.time_ns = i * DamageCurve::kFirstStep_ns,
                     .damage_ppb = static_cast<std::uint32_t>(i),
                     .rate_ppb_per_h = {}});
    ASSERT_LE(view.curve.size(), NodeView::kMostPoints);
  }
  EXPECT_EQ(view.curve.front().time_ns, 0);
  EXPECT_EQ(view.curve.back().damage_ppb, kPoints - 1);
  // 864,000 points are halved eight times before they fit into 4,000: steps of 25.6 s.
  EXPECT_GE(view.curve.size(), NodeView::kMostPoints / 2);
  for (std::size_t i = 2; i < view.curve.size(); ++i) {
    ASSERT_EQ(view.curve[i - 1].time_ns - view.curve[i - 2].time_ns, 25'600'000'000);
  }
}

TEST(DamageCurve, KeepsTheNewestPoint) {
  NodeView view;
  DamageCurve curve;
  curve.add(view, {.time_ns = 0, .damage_ppb = 1, .rate_ppb_per_h = {}});
  curve.add(view, {.time_ns = 10, .damage_ppb = 2, .rate_ppb_per_h = {}});
  curve.add(view, {.time_ns = 20, .damage_ppb = 3, .rate_ppb_per_h = {}});
  ASSERT_EQ(view.curve.size(), 2u);
  EXPECT_EQ(view.curve.back().damage_ppb, 3u);
}

TEST(Events, TheOldestGoFirst) {
  NodeView view;
  for (std::size_t i = 0; i < NodeView::kMostEvents + 5; ++i) {
    add_event(view, {.kind = EventKind::state,
                     .time_ns = static_cast<std::int64_t>(i),
                     .text = {},
                     .state = protocol::LifeState::normal});
  }
  EXPECT_EQ(view.events.size(), NodeView::kMostEvents);
  EXPECT_EQ(view.events.front().time_ns, 5);
}

NodeView node_in(protocol::LifeState state) {
  NodeView node;
  node.status.emplace();
  node.status->value.state = state;
  node.gravest_state = state;
  return node;
}

// What a person has to see first: two controllers that share an id, an emergency or a wire that is
// lost, silence, then the life state, of which unknown is graver than inspect.
TEST(Severity, PutsTheGravestNodesFirstAndOthersByTheirNumbers) {
  using protocol::LifeState;
  FleetView fleet;
  fleet.nodes[1] = node_in(LifeState::normal);
  fleet.nodes[2] = node_in(LifeState::inspect);
  fleet.nodes[3] = node_in(LifeState::normal);
  fleet.nodes[3].vanished = true;
  fleet.nodes[4] = node_in(LifeState::worn);
  fleet.nodes[5] = node_in(LifeState::normal);
  fleet.nodes[5].streams.emplace_back().damaged = 1;
  fleet.nodes[6] = node_in(LifeState::normal);
  fleet.nodes[6].status->value.broken = true;
  fleet.nodes[7] = node_in(LifeState::replace);
  fleet.nodes[8].heartbeat.emplace();
  fleet.nodes[9] = node_in(LifeState::inspect);
  fleet.nodes[10] = node_in(LifeState::normal);
  fleet.nodes[10].two_controllers = true;
  fleet.nodes[11] = node_in(LifeState::worn);
  fleet.nodes[11].emergency.emplace();
  fleet.nodes[11].emergency->value.code = protocol::EmergencyCode::overload;
  fleet.nodes[12] = {};
  for (auto& [number, node] : fleet.nodes) {
    node.node = number;
  }
  std::vector<int> order;
  for (const NodeView* node : gravest_first(fleet)) {
    order.push_back(node->node);
  }
  EXPECT_EQ(order, (std::vector<int>{10, 6, 11, 3, 4, 7, 8, 2, 9, 5, 1, 12}));
  EXPECT_EQ(severity_of(fleet.nodes[12]), 0u);
  EXPECT_EQ(severity_of(LifeState::inspect), severity_of(fleet.nodes[2]));
}

TEST(Words, PercentHasNoMoreDigitsThanItNeeds) {
  EXPECT_EQ(percent_of(0), "0");
  EXPECT_EQ(percent_of(1), "0.0000001");
  EXPECT_EQ(percent_of(121'000'000), "12.1");
  EXPECT_EQ(percent_of(1'000'000'000), "100");
  EXPECT_EQ(percent_of(4'294'967'295), ">=429.4967295");
}

}  // namespace
}  // namespace host_sim::monitor
