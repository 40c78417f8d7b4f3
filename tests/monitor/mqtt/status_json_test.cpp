#include "host_sim/monitor/mqtt/status_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host_sim/monitor/mqtt/mqtt_observer.hpp"

namespace host_sim::monitor {
namespace {

NodeView reported_node() {
  NodeView node;
  node.node = 5;
  node.status = {{.state = protocol::LifeState::inspect,
                  .damage_ppb = 612'345'678,
                  .worst_tendon = 2,
                  .quality = protocol::Quality::gaps,
                  .storage_ok = true,
                  .gap = true},
                 1'600'000'000'123'456'789};
  node.highest_damage_ppb = 612'345'678;
  node.rate = {{.ppb_per_h = 5'000'000}, 0};
  node.conditional = {{.to_10_dh = 250, .to_50_dh = 0xfffe, .to_90_dh = 0xffff}, 0};
  node.break_risk = {{.horizon_h = 8, .within_horizon = 26}, 0};
  node.remaining = {{.b10_dh = 123, .b50_dh = 200, .b90_dh = 0xffff}, 0};
  return node;
}

TEST(StatusJson, HoldsWhatTheNodeTold) {
  const auto json = nlohmann::json::parse(status_json(reported_node()));
  EXPECT_EQ(json, nlohmann::json::parse(R"({
    "state": "inspect", "damage_ppb": 612345678, "damage_percent": 61.2345678, "worst_tendon": 2,
    "quality": "gaps", "storage_ok": true, "sensor_ok": false, "gap": true, "saturated": false,
    "overrun": false, "locked": false, "broken": false, "slack": false, "time_s": 1600000000.123, "stale": false,
    "vanished": false, "integrity_failures": 0, "damage_percent_per_h": 0.5,
    "remaining_h": {"b10": 12.3, "b50": 20.0, "b90": null},
    "hours_given_survival": {"risk_10_percent": 25.0, "risk_50_percent": 6553.4,
                             "risk_90_percent": null},
    "break_risk_percent": 0.65, "break_risk_horizon_h": 8,
    "at_least": ["hours_given_survival.risk_50_percent"]})"));
}

TEST(StatusJson, ARateThatIsNotKnownYetIsNull) {
  NodeView node = reported_node();
  node.rate->value.ppb_per_h = 0xffff'ffff;
  EXPECT_TRUE(nlohmann::json::parse(status_json(node)).at("damage_percent_per_h").is_null());
}

TEST(StatusJson, ABreakRiskThatIsNotKnownYetIsNull) {
  NodeView node = reported_node();
  node.break_risk->value.within_horizon = 0xfff;
  EXPECT_TRUE(nlohmann::json::parse(status_json(node)).at("break_risk_percent").is_null());
}

TEST(StatusJson, HasWhatIsAdvised) {
  using protocol::AdviceState;
  NodeView node = reported_node();
  node.advice[0] = {{.tendon = 0, .state = AdviceState::off}, 0};
  EXPECT_FALSE(nlohmann::json::parse(status_json(node)).contains("advice"));
  node.advice[1] = {
      {.tendon = 1, .state = AdviceState::limited, .highest_tension = 1005, .pace = 2590}, 0};
  node.advice[2] = {{.tendon = 2, .state = AdviceState::unknown}, 0};
  node.advice[3] = node.advice[1];
  node.advice[3].stale = true;
  EXPECT_EQ(nlohmann::json::parse(status_json(node)).at("advice"), nlohmann::json::parse(R"([
    {"tendon": 1, "state": "limited", "highest_tension_percent": 25.125, "pace_percent": 64.75},
    {"tendon": 2, "state": "unknown", "highest_tension_percent": null, "pace_percent": null}])"));
}

TEST(StatusJson, NamesWhatIsAtTheEndOfItsRange) {
  NodeView node = reported_node();
  node.highest_damage_ppb = 0xffff'ffff;
  node.rate->value.ppb_per_h = 0xffff'fffe;
  node.remaining->value.b90_dh = 0xfffe;
  EXPECT_EQ(nlohmann::json::parse(status_json(node)).at("at_least"),
            nlohmann::json::parse(R"(["damage_ppb", "damage_percent", "damage_percent_per_h",
                                      "remaining_h.b90",
                                      "hours_given_survival.risk_50_percent"])"));
}

TEST(StatusJson, TwoControllersAreTheGravestState) {
  NodeView node = reported_node();
  node.two_controllers = true;
  const auto json = nlohmann::json::parse(status_json(node));
  EXPECT_EQ(json.at("state"), "two_controllers");
  EXPECT_EQ(json.at("life_state"), "inspect");
}

TEST(StatusJson, LeavesOutPagesThatAreStale) {
  NodeView node = reported_node();
  node.status->stale = true;
  node.rate->stale = true;
  node.remaining->stale = true;
  node.conditional->stale = true;
  node.break_risk->stale = true;
  const auto json = nlohmann::json::parse(status_json(node));
  EXPECT_TRUE(json.at("stale").get<bool>());
  EXPECT_FALSE(json.contains("damage_percent_per_h"));
  EXPECT_FALSE(json.contains("remaining_h"));
  EXPECT_FALSE(json.contains("hours_given_survival"));
  EXPECT_FALSE(json.contains("break_risk_percent"));
}

TEST(StatusJson, IsEmptyBeforeAStatus) {
  EXPECT_EQ(status_json(NodeView{}), "");
}

TEST(BrokerAddress, HasAHostAndAPort) {
  EXPECT_EQ(broker_address_of("localhost")->port, 1883);
  EXPECT_EQ(broker_address_of("broker.lan:8883")->host, "broker.lan");
  EXPECT_EQ(broker_address_of("broker.lan:8883")->port, 8883);
  EXPECT_EQ(broker_address_of("[::1]:1884")->host, "::1");
  EXPECT_EQ(broker_address_of("[::1]:1884")->port, 1884);
  for (const char* wrong : {"", ":1883", "host:", "host:0", "host:65536", "host:12a", "a b:1",
                            "[::1", "[::1]1884", "mqtt://host"}) {
    EXPECT_FALSE(broker_address_of(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace host_sim::monitor
