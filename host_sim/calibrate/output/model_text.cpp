#include <fmt/format.h>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/campaign/nominal_model.hpp"
#include "host_sim/model/life_interval.hpp"

namespace host_sim::calibrate {

using hal::files::InputError;
using hal::files::printable;

namespace {

Model::Life::Interval::Ends ends_of(const Interval& interval) {
  return {interval.low, interval.high};
}

/// With intervals where a model can hold them: not where one has no end, or an exponent below 0.
Model::Life fitted_life(const StressLife& fit) {
  Model::Life life{Model::MeanStress::kGerber, fit.law.scale, fit.law.exponent, fit.law.shape};
  const Model::Life::Interval interval{
      .level = kConfidence,
      .ipl_scale = ends_of(fit.scale_ci95),
      .ipl_exponent = ends_of(fit.exponent_ci95),
      .weibull_shape = ends_of(fit.shape_ci95),
      .pivot_tension_N = fit.pivot_tension_N,
      .life_at_pivot = ends_of(fit.life_at_pivot_ci95),
  };
  if (can_be_written(interval, life)) {
    life.interval = interval;
  }
  return life;
}

Model fitted_model(const Campaign& campaign, const StressLife& fit) {
  const NominalModel& nominal = campaign.nominal;
  return {*nominal.cable, *nominal.sheath, nominal.drive, *nominal.counting, fitted_life(fit), {},
          nominal.watch};
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
  text += fmt::format("# 95 %: ipl_scale {}, ipl_exponent {}, weibull_shape {}.\n",
                      figure(life.scale_ci95), figure(life.exponent_ci95), figure(life.shape_ci95));
  if (!fitted_life(life).interval) {
    text += "# No [life.interval]: it has ends above 0 on both sides.\n";
  }
  return text + "schema = 1\n";
}

}  // namespace

std::string model_text(const Campaign& campaign, const CalibrateResult& result,
                       std::string_view program_version) {
  if (!result.stress_life) {
    throw InputError(campaign.folder.string(), 0, 0, "no life law could be fitted",
                     "without --out, to see why");
  }
  return head(result, program_version) +
         model_tables(campaign, fitted_model(campaign, *result.stress_life), "fitted");
}

}  // namespace host_sim::calibrate
