#include "host_sim/model/watch.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "hal/files/text.hpp"

namespace host_sim {

using hal::files::NumberKey;
using hal::files::toml_float;
using hal::files::TomlTable;

namespace {

struct WatchKey {
  NumberKey number;
  double Model::Watch::*value;
  std::string_view needs;  ///< the key that may not be 0 where this one is not
};

constexpr std::array<WatchKey, 7> kWatchKeys{{
    {{"minimum_tension_N", "N", {0, 1e6}}, &Model::Watch::minimum_tension_N, ""},
    {{"broken_tension_N", "N", {0, 1e6}}, &Model::Watch::broken_tension_N, "broken_travel_mm"},
    {{"broken_travel_mm", "mm", {0, 1e6}}, &Model::Watch::broken_travel_mm, "broken_tension_N"},
    {{"slack_travel_mm", "mm", {0, 1e6}}, &Model::Watch::slack_travel_mm, "minimum_tension_N"},
    {{"horizon_h", "h", {0.001, 87600}}, &Model::Watch::horizon_h, ""},
    {{"advice_risk", "", {0, 0.99}}, &Model::Watch::advice_risk, "advice_until_h"},
    {{"advice_until_h", "h", {0, 1e6}}, &Model::Watch::advice_until_h, "advice_risk"},
}};

const WatchKey& key_named(std::string_view name) {
  for (const WatchKey& key : kWatchKeys) {
    if (key.number.name == name) {
      return key;
    }
  }
  return kWatchKeys.front();
}

}  // namespace

Model::Watch read_watch(const TomlTable& table) {
  std::vector<NumberKey> numbers;
  numbers.reserve(kWatchKeys.size());
  for (const WatchKey& key : kWatchKeys) {
    numbers.push_back(key.number);
  }
  table.refuse_unknown_keys(numbers, {});
  Model::Watch watch;
  for (const WatchKey& key : kWatchKeys) {
    watch.*key.value = table.number_or(key.number, watch.*key.value);
  }
  for (const WatchKey& key : kWatchKeys) {
    if (watch.*key.value == 0 || key.needs.empty()) {
      continue;
    }
    if (watch.*key_named(key.needs).value == 0) {
      table.fail(table.place_of(key.number.name),
                 fmt::format("{} is {} without {}", key.number.name, watch.*key.value, key.needs),
                 fmt::format("{} above 0 too, or {} = 0", key.needs, key.number.name));
    }
  }
  return watch;
}

void check_watch(const TomlTable& table, const Model::Watch& watch, const Model::Cable& cable) {
  for (const WatchKey& key : kWatchKeys) {
    if (key.number.unit == "N" && watch.*key.value >= cable.ultimate_tension_N) {
      table.fail(
          table.place_of(key.number.name),
          fmt::format("{} is {}", key.number.name, watch.*key.value),
          fmt::format("less than ultimate_tension_N, which is {}", cable.ultimate_tension_N));
    }
  }
}

std::string watch_text(const Model::Watch& watch, std::string_view prefix) {
  std::string text;
  for (const WatchKey& key : kWatchKeys) {
    text += fmt::format("{}{} = {}\n", prefix, key.number.name, toml_float(watch.*key.value + 0.0));
  }
  return text;
}

}  // namespace host_sim
