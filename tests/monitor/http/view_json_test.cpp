#include "host_sim/monitor/http/view_json.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "tests/monitor/http/made_view.hpp"

namespace host_sim::monitor {
namespace {

using nlohmann::json;

TEST(ViewJson, TellsMessagesInTheWordsOfTheFramePlan) {
  const json node = node_json(test::made_view().nodes.at(5));
  EXPECT_EQ(node["status"], json::parse(R"({"LifeState": "inspect", "Damage": 0.123456789,
      "WorstTendon": 2, "Quality": "measured", "StorageOk": true, "SensorOk": false, "Gap": false,
      "Saturated": false, "Overrun": false, "Locked": false, "Broken": false, "Slack": false, "time_us": 9000000, "stale": true})"));
  EXPECT_EQ(node["heartbeat"],
            json::parse(R"({"NmtState": "operational", "time_us": 9000000, "stale": false})"));
  EXPECT_EQ(node["identity"]["Configuration"], 0xdeadbeef);
  EXPECT_EQ(node["remaining"]["RemainingB10"], 1.5);
  EXPECT_EQ(node["remaining"]["RemainingB50"], 6553.4);
  EXPECT_EQ(node["remaining"]["RemainingB90"], "unknown");
  EXPECT_EQ(node["tendons"]["2"]["TendonDamage"], 1e-9);
  EXPECT_EQ(node["remaining"]["at_least"], json::parse(R"(["RemainingB50"])"));
  EXPECT_EQ(node["bins"]["156"]["BinCycles"], 77);
  EXPECT_EQ(node["bins"]["156"]["BinHalfCycles"], 31);
  EXPECT_EQ(node["bins"]["156"]["at_least"], json::parse(R"(["BinHalfCycles"])"));
  EXPECT_EQ(node["highest_damage"], 0.123456789);
  EXPECT_EQ(node["integrity_failures"], 3);
  EXPECT_EQ(node["severity"], 30);
}

TEST(ViewJson, NamesWhatIsAtTheEndOfItsRange) {
  NodeView node = test::made_view().nodes.at(5);
  EXPECT_FALSE(node_json(node).contains("at_least"));
  node.highest_damage_ppb = 0xffff'ffff;
  node.status->value.damage_ppb = 0xffff'ffff;
  node.cycles = {protocol::detail::Cycles{0xffff'fffe, 0xfffe}, 0, false};
  node.rate = {protocol::detail::DamageRate{0xffff'ffff, 0xffff}, 0, false};
  node.storage = {protocol::detail::Storage{0xffff'ff, 0xffff'ff}, 0, false};
  node.bus = {protocol::detail::Bus{255, 255, 255, 254, 0xffff}, 0, false};
  const json full = node_json(node);
  EXPECT_EQ(full["at_least"], json::parse(R"(["highest_damage"])"));
  EXPECT_EQ(full["status"]["at_least"], json::parse(R"(["Damage"])"));
  EXPECT_EQ(full["cycles"]["at_least"], json::parse(R"(["CycleRate"])"));
  EXPECT_EQ(full["rate"]["at_least"], json::parse(R"(["UnsavedDamage"])"));
  EXPECT_EQ(full["storage"]["at_least"],
            json::parse(R"(["StorageSequence", "WorstUnsavedDamage"])"));
  EXPECT_EQ(full["bus"]["at_least"], json::parse(R"(["BusOffs", "Refused"])"));
  EXPECT_FALSE(full["identity"].contains("at_least"));
}

TEST(ViewJson, AMomentHasTheNodesThatItsFramesDoNotHave) {
  constexpr std::int64_t kS = 1'000'000'000;
  FleetView now = test::made_view();
  Moment moment;
  moment.from_us = 2'000'000;
  moment.view.now_ns = 5 * kS;
  const json five = moment_json(moment, now);
  EXPECT_EQ(five["from_us"], 2'000'000);
  EXPECT_EQ(five["now_us"], 5'000'000);
  EXPECT_EQ(five["nodes"]["5"], json::parse(R"({"node": 5, "partial": true,
      "highest_damage": 0.123, "status": {"time_us": 1000000, "stale": false},
      "severity": 30, "life_state": "inspect", "streams": {}, "tendons": {}, "bins": {}, "wires": {}, "advice": {}})"));
  moment.view.now_ns = 9 * kS;
  now.nodes.at(5).curve.back().damage_ppb = 0xffff'ffff;
  const json nine = moment_json(moment, now)["nodes"]["5"];
  EXPECT_EQ(nine["rate"],
            json::parse(R"({"DamageRate": 5e-9, "time_us": 9000000, "stale": false})"));
  EXPECT_EQ(nine["at_least"], json::parse(R"(["highest_damage"])"));
  moment.view.now_ns = kS / 2;
  EXPECT_TRUE(moment_json(moment, now)["nodes"].empty());
  moment.view.nodes[5].node = 5;
  EXPECT_FALSE(moment_json(moment, now)["nodes"]["5"].contains("partial"));
}

TEST(ViewJson, TimesBeforeTheArchiveAreThoseOfTheCurves) {
  FleetView now = test::made_view();
  EXPECT_EQ(times_json({}, "", now), json::parse(R"({"times_us": [1000000, 9000000]})"));
  EXPECT_EQ(times_json({9'000'000, 9'500'000}, "why", now),
            json::parse(R"({"times_us": [1000000, 9000000, 9500000], "whole_from_us": 9000000,
                            "why_gone": "why"})"));
  EXPECT_EQ(times_json({500'000}, "", now),
            json::parse(R"({"times_us": [500000], "whole_from_us": 500000})"));
  NodeView& node = now.nodes.at(5);
  node.curve.clear();
  for (std::int64_t i = 0; i < 4000; ++i) {
    node.curve.push_back({i * 1'000'000, 1, std::nullopt});
  }
  const json many = times_json({}, "", now)["times_us"];
  EXPECT_EQ(many.size(), 500u);  // every eighth
  EXPECT_EQ(many[1], 8000);
}

TEST(ViewJson, TwoControllersAreTheGravestState) {
  NodeView node = test::made_view().nodes.at(5);
  EXPECT_EQ(node_json(node)["state"], "inspect");
  EXPECT_EQ(node_json(node)["two_controllers"], false);
  node.two_controllers = true;
  EXPECT_EQ(node_json(node)["state"], "two_controllers");
  EXPECT_EQ(node_json(node)["life_state"], "inspect");
  EXPECT_EQ(node_json(node)["two_controllers"], true);
}

TEST(ViewJson, LeavesOutWhatIsNotKnown) {
  const json node = node_json(test::made_view().nodes.at(5));
  for (const char* name : {"cycles", "rate", "storage", "timing", "bus", "emergency"}) {
    EXPECT_FALSE(node.contains(name)) << name;
  }
}

TEST(ViewJson, CountsStreams) {
  const json stream = node_json(test::made_view().nodes.at(5))["streams"]["LifeStatus"];
  EXPECT_EQ(stream["good"], 90);
  EXPECT_EQ(stream["lost"], 2);
  EXPECT_EQ(stream["damaged"], 3);
  EXPECT_EQ(stream["intervals"], json::parse(R"({"20": 89})"));
  EXPECT_EQ(stream["interval_class_ms"], 5);
}

TEST(ViewJson, HasHistory) {
  EXPECT_EQ(history_json(test::made_view().nodes.at(5)), json::parse(R"({
      "events": [{"kind": "state", "time_us": 1000000, "words": "inspect", "state": "inspect"}],
      "curve": [[1000000, 0.123], [9000000, 0.123456789, 5e-9]]})"));
}

TEST(ViewJson, TellsTheBus) {
  const json fleet = fleet_json(test::made_view());
  EXPECT_EQ(fleet["now_us"], 10'000'000);
  EXPECT_EQ(fleet["source"], "can0");
  EXPECT_EQ(fleet["frames"], 42);
  EXPECT_EQ(fleet["bus_load_percent"], 1.5);
  EXPECT_EQ(fleet["bus_off"], false);
  EXPECT_EQ(fleet["nodes"].size(), 1u);
}

TEST(ViewJson, TextIsOneLineOfUtf8) {
  FleetView fleet = test::made_view();
  fleet.source = "run\n\xff.log";
  const std::string text = json_text(fleet_json(fleet));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(json::parse(text)["source"], "run\n\xef\xbf\xbd.log");
}

TEST(MergePatch, HoldsWhatChangedAlone) {
  EXPECT_EQ(merge_patch(json::parse(R"({"a": 1, "b": {"c": 2, "d": 3}, "e": [1], "f": 4})"),
                        json::parse(R"({"a": 1, "b": {"c": 5, "d": 3}, "e": [1, 2], "g": 6})")),
            json::parse(R"({"b": {"c": 5}, "e": [1, 2], "f": null, "g": 6})"));
}

TEST(MergePatch, OfEqualsIsEmpty) {
  const json value = json::parse(R"({"a": {"b": [1, 2]}})");
  EXPECT_EQ(merge_patch(value, value), json::object());
}

json any_value(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 5 : 4);
  switch (kind) {
    case 0:
      return *rc::gen::inRange(0, 3);
    case 1:
      return *rc::gen::arbitrary<bool>();
    case 2:
      return *rc::gen::element<std::string>("x", "y");
    case 3:
      return json::array({*rc::gen::inRange(0, 2)});
    default: {
      json object = json::object();
      for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        object[*rc::gen::element<std::string>("a", "b", "c", "d")] = any_value(depth - 1);
      }
      return object;
    }
  }
}

json any_object() {
  return json{{"k", any_value(3)}, {"m", any_value(2)}};
}

RC_GTEST_PROP(MergePatchProperty, LeadsFromOneToTheOther, ()) {
  const json before = any_object();
  const json after = any_object();
  json changed = before;
  changed.merge_patch(merge_patch(before, after));
  RC_ASSERT(changed == after);
}

TEST(HistoryCsv, HasALineAPoint) {
  EXPECT_EQ(history_csv(test::made_view().nodes.at(5)),
            "time_s,damage,damage_rate_per_h\n"
            "1.000000,0.123000000,\n"
            "9.000000,0.123456789,0.000000005\n");
}

}  // namespace
}  // namespace host_sim::monitor
