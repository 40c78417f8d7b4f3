#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "firmware/protocol/messages.hpp"

/// What a reader has to say about a message, written down by hand: physical values in the units of
/// the frame table, not taken from the schema.
namespace protocol::test {

using Json = nlohmann::ordered_json;

inline std::string label_of(LifeState state) {
  switch (state) {
    case LifeState::unknown:
      return "unknown";
    case LifeState::normal:
      return "normal";
    case LifeState::inspect:
      return "inspect";
    case LifeState::replace:
      return "replace";
    case LifeState::worn:
      return "worn";
  }
  return {};
}
inline std::string label_of(Quality quality) {
  switch (quality) {
    case Quality::measured:
      return "measured";
    case Quality::gaps:
      return "gaps";
    case Quality::bounded:
      return "bounded";
    case Quality::saturated:
      return "saturated";
    case Quality::untrusted:
      return "untrusted";
  }
  return {};
}
inline std::string label_of(WireEvent event) {
  switch (event) {
    case WireEvent::above_50:
      return "above_50";
    case WireEvent::above_70:
      return "above_70";
    case WireEvent::above_90:
      return "above_90";
    case WireEvent::slack:
      return "slack";
  }
  return {};
}
inline std::string label_of(AdviceState state) {
  switch (state) {
    case AdviceState::off:
      return "off";
    case AdviceState::unknown:
      return "unknown";
    case AdviceState::no_limit:
      return "no_limit";
    case AdviceState::limited:
      return "limited";
    case AdviceState::unreachable:
      return "unreachable";
    case AdviceState::over:
      return "over";
  }
  return {};
}
inline std::string label_of(NmtState state) {
  switch (state) {
    case NmtState::boot_up:
      return "boot_up";
    case NmtState::stopped:
      return "stopped";
    case NmtState::operational:
      return "operational";
  }
  return {};
}
inline std::string label_of(CommandCode code) {
  switch (code) {
    case CommandCode::identify:
      return "identify";
    case CommandCode::select_page:
      return "select_page";
    case CommandCode::burst:
      return "burst";
  }
  return {};
}
inline std::string label_of(EmergencyCode code) {
  switch (code) {
    case EmergencyCode::none:
      return "none";
    case EmergencyCode::emergency_stop:
      return "emergency_stop";
    case EmergencyCode::life_inspect:
      return "life_inspect";
    case EmergencyCode::life_replace:
      return "life_replace";
    case EmergencyCode::life_worn:
      return "life_worn";
    case EmergencyCode::overload:
      return "overload";
    case EmergencyCode::tendon_broken:
      return "tendon_broken";
    case EmergencyCode::tendon_slack:
      return "tendon_slack";
    case EmergencyCode::sensor:
      return "sensor";
    case EmergencyCode::storage:
      return "storage";
    case EmergencyCode::record_damaged:
      return "record_damaged";
    case EmergencyCode::parameters:
      return "parameters";
    case EmergencyCode::settings:
      return "settings";
    case EmergencyCode::bus:
      return "bus";
    case EmergencyCode::deadline:
      return "deadline";
    case EmergencyCode::authority:
      return "authority";
  }
  return {};
}

template <class Enum>
int code_of(Enum value) {
  return static_cast<int>(value);
}

struct Expected {
  std::string name;
  Json page;  ///< its name, or null
  Json signals;
  Json labels = Json::object();
};

inline Expected expected(const Heartbeat& m) {
  return {
      "Heartbeat", nullptr, {{"NmtState", code_of(m.state)}}, {{"NmtState", label_of(m.state)}}};
}
inline Expected expected(const LifeStatus& m) {
  return {"LifeStatus",
          nullptr,
          {{"LifeState", code_of(m.state)},
           {"Damage", m.damage_ppb * 1e-9},
           {"WorstTendon", m.worst_tendon},
           {"Quality", code_of(m.quality)},
           {"StorageOk", m.storage_ok ? 1 : 0},
           {"SensorOk", m.sensor_ok ? 1 : 0},
           {"Gap", m.gap ? 1 : 0},
           {"Saturated", m.saturated ? 1 : 0},
           {"Overrun", m.overrun ? 1 : 0},
           {"Locked", m.locked ? 1 : 0},
           {"Broken", m.broken ? 1 : 0},
           {"Slack", m.slack ? 1 : 0}},
          {{"LifeState", label_of(m.state)}, {"Quality", label_of(m.quality)}}};
}
inline Expected expected(const detail::Identity& m) {
  return {"LifeDetail",
          "Identity",
          {{"SchemaVersion", m.schema},
           {"FirmwareVersion", m.firmware},
           {"Configuration", m.configuration}}};
}
inline Expected expected(const detail::Cycles& m) {
  Expected result{"LifeDetail", "Cycles", {{"Cycles", m.cycles}, {"CycleRate", m.cycles_per_min}}};
  if (m.cycles_per_min == 0xffff) {
    result.labels["CycleRate"] = "unknown";
  }
  return result;
}
inline Expected expected(const detail::DamageRate& m) {
  Expected result{"LifeDetail",
                  "DamageRate",
                  {{"DamageRate", m.ppb_per_h * 1e-9}, {"UnsavedDamage", m.unsaved_ppb * 1e-9}}};
  if (m.ppb_per_h == 0xffff'ffff) {
    result.labels["DamageRate"] = "unknown";
  }
  return result;
}
inline Expected expected(const detail::TendonDamage& m) {
  return {"LifeDetail",
          "TendonDamage",
          {{"Tendon", m.tendon},
           {"TendonDamage", m.damage_ppb * 1e-9},
           {"TendonLifeState", code_of(m.state)}},
          {{"TendonLifeState", label_of(m.state)}}};
}
inline Expected expected(const detail::RainflowBin& m) {
  return {"LifeDetail",
          "RainflowBin",
          {{"BinTendon", m.tendon},
           {"BinRange", m.range_class},
           {"BinMean", m.mean_class},
           {"BinHalfCycles", m.half_cycles},
           {"BinCycles", m.cycles}}};
}
inline Expected expected(const detail::RemainingLife& m) {
  Expected result{"LifeDetail",
                  "RemainingLife",
                  {{"RemainingB10", m.b10_dh * 0.1},
                   {"RemainingB50", m.b50_dh * 0.1},
                   {"RemainingB90", m.b90_dh * 0.1}}};
  const auto name_unknown = [&](const char* signal, std::uint16_t raw) {
    if (raw == 0xffff) {
      result.labels[signal] = "unknown";
    }
  };
  name_unknown("RemainingB10", m.b10_dh);
  name_unknown("RemainingB50", m.b50_dh);
  name_unknown("RemainingB90", m.b90_dh);
  return result;
}
inline Expected expected(const detail::ConditionalLife& m) {
  Expected result{"LifeDetail",
                  "ConditionalLife",
                  {{"HoursToRisk10", m.to_10_dh * 0.1},
                   {"HoursToRisk50", m.to_50_dh * 0.1},
                   {"HoursToRisk90", m.to_90_dh * 0.1}}};
  const auto name_unknown = [&](const char* signal, std::uint16_t raw) {
    if (raw == 0xffff) {
      result.labels[signal] = "unknown";
    }
  };
  name_unknown("HoursToRisk10", m.to_10_dh);
  name_unknown("HoursToRisk50", m.to_50_dh);
  name_unknown("HoursToRisk90", m.to_90_dh);
  return result;
}
inline Expected expected(const detail::BreakRisk& m) {
  Expected result{"LifeDetail",
                  "BreakRisk",
                  {{"BreakHorizon", m.horizon_h},
                   {"BreakRisk", m.within_horizon * 0.00025},
                   {"HoursToRisk10Low", m.to_10_low_30min * 0.5},
                   {"HoursToRisk10High", m.to_10_high_30min * 0.5}}};
  if (m.within_horizon == 0xfff) {
    result.labels["BreakRisk"] = "unknown";
  }
  if (m.to_10_low_30min == 0x3fff) {
    result.labels["HoursToRisk10Low"] = "unknown";
  }
  if (m.to_10_high_30min == 0x3fff) {
    result.labels["HoursToRisk10High"] = "unknown";
  }
  return result;
}
inline Expected expected(const detail::WireHistory& m) {
  return {"LifeDetail",
          "WireHistory",
          {{"WireTendon", m.tendon},
           {"WireBroken", m.broken ? 1 : 0},
           {"WireSlack", m.slack ? 1 : 0},
           {"WirePeak", m.peak_percent},
           {"WireEvent", code_of(m.event)},
           {"WireCount", m.count},
           {"BelowMinimum", m.below_minimum_min}},
          {{"WireEvent", label_of(m.event)}}};
}
inline Expected expected(const detail::Advice& m) {
  Expected result{"LifeDetail",
                  "Advice",
                  {{"AdviceTendon", m.tendon},
                   {"AdviceState", code_of(m.state)},
                   {"AdviceTension", m.highest_tension * 0.00025},
                   {"AdvicePace", m.pace * 0.00025}},
                  {{"AdviceState", label_of(m.state)}}};
  if (m.highest_tension == 0xfff) {
    result.labels["AdviceTension"] = "unknown";
  }
  if (m.pace == 0xfff) {
    result.labels["AdvicePace"] = "unknown";
  }
  return result;
}
inline Expected expected(const detail::Storage& m) {
  return {"LifeDetail",
          "Storage",
          {{"StorageSequence", m.sequence}, {"WorstUnsavedDamage", m.worst_unsaved_ppb * 1e-9}}};
}
inline Expected expected(const detail::Timing& m) {
  return {"LifeDetail",
          "Timing",
          {{"WorstJitter", m.worst_jitter_us},
           {"P99Jitter", m.p99_jitter_us},
           {"MissedDeadlines", m.missed_deadlines}}};
}
inline Expected expected(const detail::Bus& m) {
  return {"LifeDetail",
          "Bus",
          {{"TransmitErrors", m.transmit_errors},
           {"ReceiveErrors", m.receive_errors},
           {"BusOffs", m.bus_offs},
           {"DroppedPages", m.dropped},
           {"Refused", m.refused}}};
}
inline Expected expected(const Emergency& m) {
  return {"Emergency",
          nullptr,
          {{"EmergencyCode", code_of(m.code)},
           {"ErrorRegister", m.error_register},
           {"EmergencyDamage", m.damage_ppm * 1e-6}},
          {{"EmergencyCode", label_of(m.code)}}};
}
inline Expected expected(const Command& m) {
  return {"Command",
          nullptr,
          {{"CommandCode", code_of(m.code)}, {"Argument", m.argument}},
          {{"CommandCode", label_of(m.code)}}};
}

}  // namespace protocol::test
