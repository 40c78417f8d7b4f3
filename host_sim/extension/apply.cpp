#include "host_sim/extension/apply.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/model/model.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim {
namespace {

/// A parameter of an effect; 0 where the model does not have the effect.
double parameter(const Model& model, const char* id, const char* name) {
  const Extension* const effect = extension_of(model.extensions, id);
  return effect == nullptr ? 0 : value_of(*effect, name);
}

double ripple_A(const Model& model, double motor_angle_rad) {
  const double phase_rad = parameter(model, "torque_ripple", "ripple_harmonic") * motor_angle_rad;
  return parameter(model, "torque_ripple", "ripple_sine_A") * std::sin(phase_rad) +
         parameter(model, "torque_ripple", "ripple_cosine_A") * std::cos(phase_rad);
}

double gain_share(const Model& model, double winding_temperature_C) {
  const double warmer_K =
      winding_temperature_C - parameter(model, "torque_gain", "winding_reference_C");
  return std::max(ExtendedInput::kLeastGain,
                  1 - parameter(model, "torque_gain", "droop_1_K") * warmer_K);
}

reference::Drive drive_of(const Model::Drive& drive) {
  return {drive.torque_constant_Nm_per_A, drive.gear_ratio, drive.gear_efficiency,
          drive.spool_radius_mm * 1e-3, drive.current_offset_A};
}

}  // namespace

ExtendedInput::ExtendedInput(const Model& model) : model_(model), friction_(model) {}

double ExtendedInput::without_lag_N(double tension_N, double lag_s) {
  const double before_N = before_N_.value_or(tension_N);
  before_N_ = tension_N;
  const double most_N = kMostLagShare * model_.cable.ultimate_tension_N;
  const double behind_N = lag_s * (tension_N - before_N) * model_.counting.sample_rate_Hz;
  return tension_N + std::clamp(behind_N, -most_N, most_N);
}

double ExtendedInput::from_output_N(double output_tension_N, const Circumstances& at) {
  const double lag_s = std::max(0.0, parameter(model_, "filter_lag", "lag_s"));
  const double output_N = without_lag_N(output_tension_N, lag_s);
  return output_N * std::exp(friction_.log_ratio(output_N, at)) +
         parameter(model_, "friction_preload", "preload_N") * at.direction;
}

double ExtendedInput::from_current_N(double motor_current_A, const Circumstances& at) {
  const double current_A = motor_current_A -
                           parameter(model_, "current_offset", "current_offset_A") +
                           ripple_A(model_, at.motor_angle_rad);
  const double tension_N =
      reference::input_tension_from_current(current_A, drive_of(*model_.drive)) *
      gain_share(model_, at.winding_temperature_C) *
      (1 + parameter(model_, "gear_asymmetry", "gear_asymmetry") * at.direction);
  const double lag_s = std::max(0.0, -parameter(model_, "filter_lag", "lag_s"));
  return without_lag_N(tension_N, lag_s);
}

}  // namespace host_sim
