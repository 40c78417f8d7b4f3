#include "host_sim/monitor/mqtt/status_json.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {
namespace {

using nlohmann::ordered_json;
using protocol::detail::Advice;
using protocol::detail::BreakRisk;
using protocol::detail::ConditionalLife;
using protocol::detail::DamageRate;
using protocol::detail::RemainingLife;

constexpr double kPercent_ppb = 1e7;

ordered_json hours_of(std::uint16_t tenths) {
  return tenths == RemainingLife::kUnknown ? ordered_json(nullptr) : ordered_json(tenths / 10.0);
}

/// Of the tendons to which something is advised.
ordered_json advice_of(const NodeView& node) {
  ordered_json advice = ordered_json::array();
  for (const auto& [tendon, page] : node.advice) {
    if (page.stale || page.value.state == protocol::AdviceState::off) {
      continue;
    }
    const auto percent = [](std::uint16_t ratio) {
      return ratio == Advice::kUnknown ? ordered_json(nullptr)
                                       : ordered_json(100.0 * ratio / Advice::kWhole);
    };
    advice.push_back({{"tendon", tendon},
                      {"state", name_of(page.value.state)},
                      {"highest_tension_percent", percent(page.value.highest_tension)},
                      {"pace_percent", percent(page.value.pace)}});
  }
  return advice;
}

}  // namespace

std::string status_json(const NodeView& node) {
  if (!node.status) {
    return {};
  }
  const protocol::LifeStatus& status = node.status->value;
  const std::int64_t time_ms = node.status->time_ns / 1'000'000;
  ordered_json json = {{"state", state_name(node)},
                       {"damage_ppb", node.highest_damage_ppb},
                       {"damage_percent", node.highest_damage_ppb / kPercent_ppb},
                       {"worst_tendon", status.worst_tendon},
                       {"quality", name_of(status.quality)},
                       {"storage_ok", status.storage_ok},
                       {"sensor_ok", status.sensor_ok},
                       {"gap", status.gap},
                       {"saturated", status.saturated},
                       {"overrun", status.overrun},
                       {"locked", status.locked},
                       {"broken", status.broken},
                       {"slack", status.slack},
                       {"time_s", static_cast<double>(time_ms) / 1e3},
                       {"stale", node.status->stale},
                       {"vanished", node.vanished},
                       {"integrity_failures", node.integrity_failures()}};
  if (node.two_controllers) {
    json["life_state"] = name_of(node.life_state());
  }
  std::vector<std::string> at_least;
  if (is_at_least(kDamageSignal, node.highest_damage_ppb)) {
    at_least = {"damage_ppb", "damage_percent"};
  }
  if (node.rate && !node.rate->stale) {
    const std::uint32_t ppb_per_h = node.rate->value.ppb_per_h;
    json["damage_percent_per_h"] = ppb_per_h == DamageRate::kUnknownRate
                                       ? ordered_json(nullptr)
                                       : ordered_json(ppb_per_h / kPercent_ppb);
    if (is_at_least(protocol::schema::signal_of(&DamageRate::ppb_per_h), ppb_per_h)) {
      at_least.emplace_back("damage_percent_per_h");
    }
  }
  if (node.remaining && !node.remaining->stale) {
    const RemainingLife& remaining = node.remaining->value;
    const auto put = [&](const char* name, std::uint16_t RemainingLife::*member) {
      json["remaining_h"][name] = hours_of(remaining.*member);
      if (is_at_least(protocol::schema::signal_of(member), remaining.*member)) {
        at_least.push_back(fmt::format("remaining_h.{}", name));
      }
    };
    put("b10", &RemainingLife::b10_dh);
    put("b50", &RemainingLife::b50_dh);
    put("b90", &RemainingLife::b90_dh);
  }
  if (node.conditional && !node.conditional->stale) {
    const ConditionalLife& life = node.conditional->value;
    const auto put = [&](const char* name, std::uint16_t ConditionalLife::*member) {
      json["hours_given_survival"][name] = hours_of(life.*member);
      if (is_at_least(protocol::schema::signal_of(member), life.*member)) {
        at_least.push_back(fmt::format("hours_given_survival.{}", name));
      }
    };
    put("risk_10_percent", &ConditionalLife::to_10_dh);
    put("risk_50_percent", &ConditionalLife::to_50_dh);
    put("risk_90_percent", &ConditionalLife::to_90_dh);
  }
  if (node.break_risk && !node.break_risk->stale) {
    const BreakRisk& risk = node.break_risk->value;
    json["break_risk_percent"] = risk.within_horizon == BreakRisk::kUnknownRisk
                                     ? ordered_json(nullptr)
                                     : ordered_json(100.0 * risk.within_horizon / BreakRisk::kSure);
    json["break_risk_horizon_h"] = risk.horizon_h;
  }
  if (ordered_json advice = advice_of(node); !advice.empty()) {
    json["advice"] = std::move(advice);
  }
  if (!at_least.empty()) {
    json["at_least"] = at_least;
  }
  return json.dump();
}

}  // namespace host_sim::monitor
