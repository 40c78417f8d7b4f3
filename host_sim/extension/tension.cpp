#include "host_sim/extension/tension.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>

#include "host_sim/extension/model_file.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim {
namespace {

constexpr double kWearReference_cycles = 1000;
constexpr double kLoadReference_N = 50;
constexpr double kRadPerDeg = std::numbers::pi / 180;

double held_factor(double change) {
  return std::clamp(1 + change, 0.0, ExtendedFriction::kMostFactor);
}

/// A parameter of an effect; 0 where the model does not have it.
double parameter(const Model& model, const char* id, const char* name) {
  const Extension* const effect = extension_of(model.extensions, id);
  return effect == nullptr ? 0 : value_if(*effect, name).value_or(0);
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

double position_m(double motor_angle_rad, const Model::Drive& drive) {
  return motor_angle_rad * drive.spool_radius_m() / drive.gear_ratio;
}

}  // namespace

std::size_t empirical_covariate(const Extension& empirical) {
  const auto found = std::ranges::find_if(kEmpiricalCovariates, [&](const auto& key) {
    return !values_of(empirical, key.name).empty();
  });
  return static_cast<std::size_t>(found - kEmpiricalCovariates.begin());
}

ExtendedFriction::ExtendedFriction(const Model& model) : model_(model) {}

double ExtendedFriction::wear(double cycle) const {
  const Extension* const effect = extension_of(model_.extensions, "friction_wear");
  if (effect == nullptr) {
    return 0;
  }
  const double exponent = value_of(*effect, "wear_exponent");
  return value_of(*effect, "wear_coefficient") *
         (exponent > 0 ? std::pow(cycle / kWearReference_cycles, exponent)
                       : std::exp(-cycle / value_of(*effect, "run_in_cycles")));
}

double ExtendedFriction::temperature(double sheath_temperature_C) const {
  const Extension* const effect = extension_of(model_.extensions, "friction_temperature");
  return effect == nullptr ? 0
                           : value_of(*effect, "temperature_coefficient_1_K") *
                                 (sheath_temperature_C - value_of(*effect, "sheath_reference_C"));
}

double ExtendedFriction::position(double motor_angle_rad) const {
  const Extension* const effect = extension_of(model_.extensions, "friction_position");
  if (effect == nullptr || !model_.drive) {
    return 0;
  }
  const double phase_rad = 2 * std::numbers::pi * position_m(motor_angle_rad, *model_.drive) /
                           value_of(*effect, "wavelength_m");
  double sum = 0;
  for (int harmonic = 1; harmonic <= 6; ++harmonic) {
    const std::string number = std::to_string(harmonic);
    sum += value_of(*effect, "position_sine_" + number) * std::sin(harmonic * phase_rad) +
           value_of(*effect, "position_cosine_" + number) * std::cos(harmonic * phase_rad);
  }
  return sum;
}

double ExtendedFriction::velocity(double velocity_m_s) const {
  const double speed_m_s = std::abs(velocity_m_s);
  const double stribeck = parameter(model_, "friction_velocity", "stribeck_friction");
  const double fallen =
      stribeck == 0 ? 0
                    : stribeck * std::exp(-speed_m_s / parameter(model_, "friction_velocity",
                                                                 "stribeck_velocity_m_s"));
  return fallen + parameter(model_, "friction_velocity", "viscous_friction_s_m") * speed_m_s;
}

double ExtendedFriction::load_independent_N(const Covariates& at) const {
  return parameter(model_, "friction_preload", "preload_N") *
             held_factor(position(at.motor_angle_rad)) +
         parameter(model_, "friction_velocity", "viscous_N_s_m") * std::abs(at.velocity_m_s);
}

double ExtendedFriction::coefficient(const Covariates& at) const {
  const double product = model_.sheath.friction_coefficient * held_factor(wear(at.cycle)) *
                         held_factor(temperature(at.sheath_temperature_C)) *
                         held_factor(position(at.motor_angle_rad));
  return std::clamp(product + velocity(at.velocity_m_s), 0.0, kMostCoefficient);
}

double ExtendedFriction::bend_angle_rad(double nominal_rad) const {
  const Extension* const effect = extension_of(model_.extensions, "bend_angle");
  if (effect == nullptr) {
    return nominal_rad;
  }
  const std::span<const double> errors_rad = values_of(*effect, "bend_angle_error_rad");
  const std::span<const double> angles_deg = values_of(*effect, "bend_angles_deg");
  std::size_t nearest = 0;
  for (std::size_t pose = 1; pose < angles_deg.size(); ++pose) {
    if (std::abs(nominal_rad - angles_deg[pose] * kRadPerDeg) <
        std::abs(nominal_rad - angles_deg[nearest] * kRadPerDeg)) {
      nearest = pose;
    }
  }
  return std::max(0.0, nominal_rad + errors_rad[nearest]);
}

double ExtendedFriction::log_ratio(double output_tension_N, double slip,
                                   const Covariates& at) const {
  const double plain = coefficient(at) * bend_angle_rad(at.bend_angle_rad) * slip;
  const Extension* const effect = extension_of(model_.extensions, "friction_load");
  const double exponent = effect == nullptr ? 0 : value_of(*effect, "load_exponent");
  if (exponent == 0 || output_tension_N <= 0) {
    return plain;
  }
  const double term = exponent * plain * std::pow(output_tension_N / kLoadReference_N, -exponent);
  return std::log1p(std::max(term, kLeastLoadTerm - 1)) / exponent;
}

ExtendedInput::ExtendedInput(const Model& model) : model_(model), friction_(model) {}

double ExtendedInput::without_lag_N(double tension_N, double lag_s) {
  const double before_N = before_N_.value_or(tension_N);
  before_N_ = tension_N;
  const double most_N = kMostLagShare * model_.cable.ultimate_tension_N;
  const double behind_N = lag_s * (tension_N - before_N) * model_.counting.sample_rate_Hz;
  return tension_N + std::clamp(behind_N, -most_N, most_N);
}

double ExtendedInput::slip(const Covariates& at) {
  const Extension* const effect = extension_of(model_.extensions, "presliding");
  if (effect == nullptr) {
    return at.direction;
  }
  const double moved_m = std::abs(at.velocity_m_s) / model_.counting.sample_rate_Hz;
  slip_ -= (at.direction - slip_) * std::expm1(-moved_m / value_of(*effect, "presliding_length_m"));
  return std::lerp(at.direction, slip_, value_if(*effect, "presliding_share").value_or(1));
}

void ExtendedInput::travel(const Covariates& at) {
  if (at.direction != direction_) {
    direction_ = at.direction;
    travel_m_ = 0;
  }
  travel_m_ += std::abs(at.velocity_m_s) / model_.counting.sample_rate_Hz;
}

double ExtendedInput::empirical_N(double output_N, const Covariates& at) const {
  const Extension* const effect = extension_of(model_.extensions, kEmpirical);
  if (effect == nullptr) {
    return 0;
  }
  const std::size_t covariate = empirical_covariate(*effect);
  const std::array<double, kEmpiricalCovariates.size()> values{
      std::abs(output_N),
      model_.drive ? position_m(at.motor_angle_rad, *model_.drive) : 0,
      std::abs(at.velocity_m_s),
      travel_m_,
  };
  const std::span<const double> knots = values_of(*effect, kEmpiricalCovariates[covariate].name);
  const std::span<const double> forces_N =
      values_of(*effect, kEmpiricalForces[at.direction > 0 ? 0 : 1].name);
  const double value = values[covariate];
  const auto above =
      static_cast<std::size_t>(std::ranges::upper_bound(knots, value) - knots.begin());
  if (above == 0 || above == knots.size()) {
    return above == 0 ? forces_N.front() : forces_N.back();
  }
  return std::lerp(forces_N[above - 1], forces_N[above],
                   (value - knots[above - 1]) / (knots[above] - knots[above - 1]));
}

double ExtendedInput::from_output_N(double output_tension_N, const Covariates& at) {
  const double lag_s = std::max(0.0, parameter(model_, "filter_lag", "lag_s"));
  const double zero_N = parameter(model_, "load_cell_zero", "zero_N");
  const double output_N = without_lag_N(output_tension_N - zero_N, lag_s);
  travel(at);
  const double slip = this->slip(at);
  const double side = output_N < 0 ? -1 : 1;
  return output_N * std::exp(friction_.log_ratio(std::abs(output_N), side * slip, at)) +
         friction_.load_independent_N(at) * slip + empirical_N(output_N, at);
}

double ExtendedInput::from_current_N(double motor_current_A, const Covariates& at) {
  const double current_A = motor_current_A -
                           parameter(model_, "current_offset", "current_offset_A") +
                           ripple_A(model_, at.motor_angle_rad);
  const double tension_N =
      reference::input_tension_from_current(current_A, model_.drive->reference()) *
      gain_share(model_, at.winding_temperature_C) *
      (1 + parameter(model_, "gear_asymmetry", "gear_asymmetry") * at.direction);
  const double lag_s = std::max(0.0, -parameter(model_, "filter_lag", "lag_s"));
  return without_lag_N(tension_N, lag_s);
}

}  // namespace host_sim
