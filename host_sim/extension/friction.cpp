#include "host_sim/extension/friction.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>

#include "host_sim/model/model.hpp"

namespace host_sim {
namespace {

constexpr double kWearReference_cycles = 1000;
constexpr double kLoadReference_N = 50;
constexpr double kRadPerDeg = std::numbers::pi / 180;

double held_factor(double change) {
  return std::clamp(1 + change, 0.0, ExtendedFriction::kMostFactor);
}

}  // namespace

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
  const double position_m =
      motor_angle_rad * model_.drive->spool_radius_mm * 1e-3 / model_.drive->gear_ratio;
  const double phase_rad = 2 * std::numbers::pi * position_m / value_of(*effect, "wavelength_m");
  double sum = 0;
  for (int harmonic = 1; harmonic <= 6; ++harmonic) {
    const std::string number = std::to_string(harmonic);
    sum += value_of(*effect, "position_sine_" + number) * std::sin(harmonic * phase_rad) +
           value_of(*effect, "position_cosine_" + number) * std::cos(harmonic * phase_rad);
  }
  return sum;
}

double ExtendedFriction::velocity(double velocity_m_s) const {
  const Extension* const effect = extension_of(model_.extensions, "friction_velocity");
  if (effect == nullptr) {
    return 0;
  }
  const double speed_m_s = std::abs(velocity_m_s);
  return value_of(*effect, "stribeck_friction") *
             std::exp(-speed_m_s / value_of(*effect, "stribeck_velocity_m_s")) +
         value_of(*effect, "viscous_friction_s_m") * speed_m_s;
}

double ExtendedFriction::coefficient(const Circumstances& at) const {
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

double ExtendedFriction::log_ratio(double output_tension_N, const Circumstances& at) const {
  const double plain = coefficient(at) * bend_angle_rad(at.bend_angle_rad) * at.direction;
  const Extension* const effect = extension_of(model_.extensions, "friction_load");
  const double exponent = effect == nullptr ? 0 : value_of(*effect, "load_exponent");
  if (exponent == 0 || output_tension_N <= 0) {
    return plain;
  }
  const double term = exponent * plain * std::pow(output_tension_N / kLoadReference_N, -exponent);
  return std::log1p(std::max(term, kLeastLoadTerm - 1)) / exponent;
}

}  // namespace host_sim
