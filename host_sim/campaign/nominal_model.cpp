#include "host_sim/campaign/nominal_model.hpp"

#include <fmt/format.h>

#include "hal/files/input_error.hpp"
#include "host_sim/model/life_interval.hpp"
#include "host_sim/model/model_tables.hpp"
#include "host_sim/model/watch.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::range_text;
using hal::files::toml_float;

namespace {

std::string campaign_file(const Campaign& campaign) {
  return (campaign.folder / "campaign.toml").string();
}

std::string keys_of(std::string_view table) {
  std::string keys;
  for (const ModelKey& key : model_keys()) {
    if (key.table == table) {
      keys += fmt::format("{}{} {}", keys.empty() ? "" : ", ", key.key, range_text(key.range));
    }
  }
  return keys;
}

void require(bool there, const Campaign& campaign, std::string_view table) {
  if (!there) {
    throw InputError(campaign_file(campaign), 0, 0,
                     fmt::format("no table [model.{}], which --out needs", table),
                     fmt::format("[model.{}] with {}", table, keys_of(table)));
  }
}

void check_range(const Campaign& campaign, const ModelKey& key, double value,
                 std::string_view how) {
  if (!key.range.contains(value)) {
    throw InputError(
        campaign_file(campaign), 0, 0,
        fmt::format("the {} {} is {:.4g}, which no model can hold", how, key.key, value),
        fmt::format("data whose {} is {}", key.key, range_text(key.range)));
  }
}

}  // namespace

void require_nominal_model(const Campaign& campaign) {
  const NominalModel& nominal = campaign.nominal;
  require(nominal.cable.has_value(), campaign, "cable");
  require(nominal.sheath.has_value(), campaign, "sheath");
  require(nominal.counting.has_value(), campaign, "counting");
  if (nominal.counting->hysteresis_N >= nominal.cable->ultimate_tension_N) {
    throw InputError(campaign_file(campaign), 0, 0,
                     fmt::format("hysteresis_N is {}", nominal.counting->hysteresis_N),
                     fmt::format("less than ultimate_tension_N, which is {}",
                                 nominal.cable->ultimate_tension_N));
  }
}

void require_nominal_life(const Campaign& campaign) {
  require(campaign.nominal.life.has_value(), campaign, "life");
}

std::string model_tables(const Campaign& campaign, Model model, std::string_view how) {
  std::string text;
  std::string_view table;
  for (const ModelKey& key : model_keys()) {
    if (key.table == "drive" && !model.drive) {
      continue;
    }
    if (key.table != table) {
      table = key.table;
      text += fmt::format("\n[{}]\n", table);
      if (table == "life") {
        text += fmt::format("mean_stress = \"{}\"\n", name_of(model.life.mean_stress));
      }
    }
    check_range(campaign, key, key.value(model), how);
    text += fmt::format("{} = {}\n", key.key, toml_float(key.value(model)));
  }
  if (model.life.interval) {
    text += "\n[life.interval]\n" + life_interval_text(*model.life.interval, "");
  }
  if (model.watch) {
    text += "\n[watch]\n" + watch_text(*model.watch, "");
  }
  return text;
}

}  // namespace host_sim
