#include "host_sim/replay/constants.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/fixed.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim {

using hal::files::InputError;

namespace {

using lifemodel::BlockError;

/// What the board accepts in place of a value that `model.toml` may hold.
std::string accepted_by_board(BlockError error, const Model& model) {
  const double ultimate_N = model.cable.ultimate_tension_N;
  switch (error) {
    case BlockError::ipl_scale: {
      const double one_cycle_at_ultimate = std::pow(ultimate_N, model.life.ipl_exponent);
      return fmt::format("ipl_scale {:.3g}..{:.3g} with this ultimate_tension_N and ipl_exponent",
                         std::ldexp(one_cycle_at_ultimate, -500),
                         std::ldexp(one_cycle_at_ultimate, 500));
    }
    case BlockError::drive:
      return fmt::format(
          "torque_constant_Nm_per_A * gear_ratio * gear_efficiency / spool radius of "
          "{:.3g}..{:.3g} N/A with this ultimate_tension_N",
          std::ldexp(ultimate_N, -37), std::ldexp(ultimate_N, 25));
    case BlockError::hysteresis:
      return "hysteresis_N below ultimate_tension_N by at least one part in 1e9";
    case BlockError::none:
    case BlockError::ultimate_tension:
    case BlockError::wrong_size:
    case BlockError::not_a_block:
    case BlockError::unknown_version:
    case BlockError::damaged:
    case BlockError::ipl_exponent:
    case BlockError::weibull_shape:
    case BlockError::life_points:
    case BlockError::friction_coefficient:
    case BlockError::bend_angle:
    case BlockError::sample_period:
    case BlockError::uncertainty:
    case BlockError::watch_limits:
      break;
  }
  return "a model within the ranges of the parameter block";
}

lifemodel::pack::FitIntervals intervals_of(const Model::Life::Interval& fit,
                                           std::string_view model_name) {
  constexpr double kLevelOfBoard = 0.95;
  if (fit.level != kLevelOfBoard) {
    throw InputError(model_name, 0, 0, fmt::format("level of [life.interval] is {}", fit.level),
                     "level 0.95, which is that of the board");
  }
  return {.ipl_exponent = {fit.ipl_exponent.low, fit.ipl_exponent.high},
          .weibull_shape = {fit.weibull_shape.low, fit.weibull_shape.high},
          .pivot_tension_N = fit.pivot_tension_N,
          .life_at_pivot = {fit.life_at_pivot.low, fit.life_at_pivot.high}};
}

}  // namespace

double radians(double angle_deg) {
  return angle_deg * std::numbers::pi / 180;
}

reference::Constants reference_constants_of(const Model& model) {
  return {model.cable.ultimate_tension_N, model.counting.hysteresis_N, model.life.ipl_scale,
          model.life.ipl_exponent, model.life.weibull_shape};
}

lifemodel::Parameters parameters_of(const Model& model, std::string_view model_name) {
  lifemodel::pack::Constants constants{
      .ultimate_tension_N = model.cable.ultimate_tension_N,
      .hysteresis_N = model.counting.hysteresis_N,
      .ipl_scale = model.life.ipl_scale,
      .ipl_exponent = model.life.ipl_exponent,
      .weibull_shape = model.life.weibull_shape,
      .friction_coefficient = model.sheath.friction_coefficient,
      .bend_angle_rad = radians(model.sheath.bend_angle_deg),
      .tension_per_current_N_A = std::nullopt,
      .current_offset_A = 0,
      .sample_period_s = 1 / model.counting.sample_rate_Hz,
      .model_digest = 0,
  };
  if (model.life.interval) {
    constants.intervals = intervals_of(*model.life.interval, model_name);
  }
  if (model.watch) {
    const Model::Watch& watch = *model.watch;
    constants.watch = {.minimum_tension_N = watch.minimum_tension_N,
                       .broken_tension_N = watch.broken_tension_N,
                       .broken_travel_mm = watch.broken_travel_mm,
                       .slack_travel_mm = watch.slack_travel_mm,
                       .horizon_h = watch.horizon_h,
                       .advice_risk = watch.advice_risk,
                       .advice_until_h = watch.advice_until_h};
  }
  if (model.drive) {
    reference::Drive drive = model.drive->reference();
    constants.current_offset_A = drive.current_offset_A;
    drive.current_offset_A = 0;
    constants.tension_per_current_N_A = reference::input_tension_from_current(1, drive);
  }
  const std::string digest = model_digest(model);
  std::from_chars(digest.data(), digest.data() + digest.size(), constants.model_digest, 16);
  const auto parameters = lifemodel::pack::parameters(constants);
  if (!parameters) {
    throw InputError(
        model_name, 0, 0,
        fmt::format("the board cannot represent it: {}", lifemodel::to_string(parameters.error())),
        accepted_by_board(parameters.error(), model));
  }
  return *parameters;
}

lifemodel::ExtendedParameters extended_parameters_of(const Model& model,
                                                     std::string_view model_name) {
  return {parameters_of(model, model_name), fixed_extension(model, model.extensions, model_name)};
}

}  // namespace host_sim
