#include "host_sim/calibrate/output/model_text.hpp"

#include <fmt/format.h>

#include "host_sim/calibrate/output/number_text.hpp"
#include "host_sim/io/input_error.hpp"
#include "host_sim/io/model_keys.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim::calibrate {
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

Model fitted_model(const Campaign& campaign, const LifeLaw& law) {
  const Campaign::Nominal& nominal = campaign.nominal;
  return {*nominal.cable,
          *nominal.sheath,
          nominal.drive,
          *nominal.counting,
          {Model::MeanStress::kGerber, law.scale, law.exponent, law.shape}};
}

/// The shortest digits that read back exactly, as a TOML float.
std::string toml_float(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

void check_range(const Campaign& campaign, const ModelKey& key, double value) {
  if (!key.range.contains(value)) {
    throw InputError(
        campaign_file(campaign), 0, 0,
        fmt::format("the fitted {} is {:.4g}, which no model can hold", key.key, value),
        fmt::format("data whose {} is {}", key.key, range_text(key.range)));
  }
}

std::string head(const CalibrateResult& result, std::string_view program_version) {
  const StressLife& life = *result.stress_life;
  std::size_t failed = result.failed;
  std::size_t suspended = result.suspended;
  std::string without;
  for (const LevelResult& level : result.levels) {
    if (level.role == Campaign::Role::fit && !level.left_out.empty()) {
      failed -= level.failed();
      suspended -= level.sample.size() - level.failed();
      without +=
          fmt::format("# Without its level {}: {}.\n", level.name(), printable(level.left_out));
    }
  }
  std::string text = fmt::format(
      "# Written by host_sim calibrate {} from the campaign {}.\n"
      "# [life] by maximum likelihood from {} specimens, {} failed and {} suspended.\n",
      program_version, printable(result.campaign), failed + suspended, failed, suspended);
  text += without;
  text += fmt::format("# 95 %: ipl_scale {}, ipl_exponent {}, weibull_shape {}.\nschema = 1\n",
                      figure(life.scale_ci95), figure(life.exponent_ci95), figure(life.shape_ci95));
  return text;
}

}  // namespace

void require_nominal_model(const Campaign& campaign) {
  const Campaign::Nominal& nominal = campaign.nominal;
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

std::string model_text(const Campaign& campaign, const CalibrateResult& result,
                       std::string_view program_version) {
  if (!result.stress_life) {
    throw InputError(campaign.folder.string(), 0, 0, "no life law could be fitted",
                     "without --out, to see why");
  }
  Model model = fitted_model(campaign, result.stress_life->law);
  std::string text = head(result, program_version);
  std::string_view table;
  for (const ModelKey& key : model_keys()) {
    if (key.table == "drive" && !model.drive) {
      continue;
    }
    if (key.table != table) {
      table = key.table;
      text += fmt::format("\n[{}]\n", table);
      text += table == "life" ? "mean_stress = \"gerber\"\n" : "";
    }
    check_range(campaign, key, key.value(model));
    text += fmt::format("{} = {}\n", key.key, toml_float(key.value(model)));
  }
  return text;
}

}  // namespace host_sim::calibrate
