#include <array>

#include "host_sim/synth/plan/tables.hpp"
#include "host_sim/synth/plan/toml_values.hpp"

namespace host_sim::synth {
namespace {

constexpr NumberKey kLogSd{"log_tension_sd", "", {0, 1}};
constexpr NumberKey kAr1{"ar1", "", {-0.999, 0.999}};
constexpr NumberKey kDof{"student_t_dof", "", {2, 1000, true}};
constexpr NumberKey kTensionStep{"tension_resolution_N", "N", {0, 10}};
constexpr NumberKey kCurrentStep{"current_resolution_A", "A", {0, 10}};
constexpr NumberKey kVelocitySd{"velocity_sd_m_s", "m_s", {0, 1}};
constexpr NumberKey kVelocityStep{"velocity_resolution_m_s", "m_s", {0, 1}};
constexpr NumberKey kTemperatureSd{"temperature_sd_C", "C", {0, 50}};
constexpr NumberKey kJitter{"clock_jitter_s", "s", {0, 1}};
constexpr NumberKey kDrift{"clock_drift_ppm", "ppm", {-100'000, 100'000}};
constexpr std::array kNoise{kLogSd,      kAr1,          kDof,           kTensionStep, kCurrentStep,
                            kVelocitySd, kVelocityStep, kTemperatureSd, kJitter,      kDrift};

constexpr NumberKey kGainSd{"log_gain_sd", "", {0, 0.5}};
constexpr NumberKey kFrictionSd{"friction_sd", "", {0, 0.2}};
constexpr std::array kScatter{kGainSd, kFrictionSd};

constexpr NumberRange kTime_s{0.01, 1e6};
constexpr NumberRange kHeating_K_W{0, 1e4};
constexpr NumberKey kRoom{"room_C", "C", {-50, 100}};
constexpr NumberKey kSheathTime{"sheath_time_constant_s", "s", kTime_s};
constexpr NumberKey kSheathHeating{"sheath_K_per_W", "K_per_W", kHeating_K_W};
constexpr NumberKey kWindingTime{"winding_time_constant_s", "s", kTime_s};
constexpr NumberKey kWindingHeating{"winding_K_per_W", "K_per_W", kHeating_K_W};
constexpr NumberKey kResistance{"winding_resistance_ohm", "ohm", {0, 1e4}};
constexpr std::array kThermal{kRoom,        kSheathTime,     kSheathHeating,
                              kWindingTime, kWindingHeating, kResistance};

}  // namespace

Noise noise_in(const TomlTable& table) {
  table.refuse_unknown_keys(kNoise, {});
  Noise noise;
  noise.log_tension_sd = number_or(table, kLogSd, 0);
  noise.ar1 = number_or(table, kAr1, 0);
  noise.student_t_dof = number_or(table, kDof, 0);
  noise.tension_resolution_N = number_or(table, kTensionStep, 0);
  noise.current_resolution_A = number_or(table, kCurrentStep, 0);
  noise.velocity_sd_m_s = number_or(table, kVelocitySd, 0);
  noise.velocity_resolution_m_s = number_or(table, kVelocityStep, 0);
  noise.temperature_sd_C = number_or(table, kTemperatureSd, 0);
  noise.clock_jitter_s = number_or(table, kJitter, 0);
  noise.clock_drift_ppm = number_or(table, kDrift, 0);
  return noise;
}

ScatterPlan scatter_in(const TomlTable& table) {
  table.refuse_unknown_keys(kScatter, {});
  return {number_or(table, kGainSd, 0), number_or(table, kFrictionSd, 0)};
}

Thermal thermal_in(const TomlTable& table) {
  table.refuse_unknown_keys(kThermal, {});
  Thermal thermal;
  thermal.room_C = number_or(table, kRoom, thermal.room_C);
  thermal.sheath_time_constant_s = number_or(table, kSheathTime, thermal.sheath_time_constant_s);
  thermal.sheath_K_per_W = number_or(table, kSheathHeating, thermal.sheath_K_per_W);
  thermal.winding_time_constant_s = number_or(table, kWindingTime, thermal.winding_time_constant_s);
  thermal.winding_K_per_W = number_or(table, kWindingHeating, thermal.winding_K_per_W);
  thermal.winding_resistance_ohm = number_or(table, kResistance, thermal.winding_resistance_ohm);
  return thermal;
}

}  // namespace host_sim::synth
