#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::effects {

/// A covariate that a signature reads.
struct Need {
  std::vector<double> recording::Covariates::*values;
  std::string_view description;  ///< what it is and the channel that gives it
};

// The covariates that signatures read, with what to record for them.
inline constexpr Need kCycleNeed{&recording::Covariates::cycle,
                                 "cycle number (start_cycle in sessions.csv)"};
inline constexpr Need kVelocityNeed{&recording::Covariates::velocity_m_s,
                                    "velocity (tendon_velocity_m_s)"};
inline constexpr Need kTravelNeed{&recording::Covariates::travel_m,
                                  "travel since the last reversal (tendon_velocity_m_s)"};
inline constexpr Need kPositionNeed{&recording::Covariates::position_m,
                                    "tendon position (motor_angle_rad or tendon_velocity_m_s)"};
inline constexpr Need kMotorAngleNeed{&recording::Covariates::motor_angle_rad,
                                      "rotor angle (motor_angle_rad)"};
inline constexpr Need kCurrentNeed{&recording::Covariates::current_A,
                                   "motor current (motor_current_A)"};
inline constexpr Need kTensionRateNeed{&recording::Covariates::log_tension_rate_1_s,
                                       "rate of input tension (time_s and an input tension)"};
inline constexpr Need kOutputRateNeed{&recording::Covariates::log_output_rate_1_s,
                                      "rate of output tension (time_s and output_tension_N)"};
inline constexpr Need kSheathTemperatureNeed{&recording::Covariates::sheath_temperature_C,
                                             "sheath temperature (sheath_temperature_C)"};
inline constexpr Need kWindingTemperatureNeed{&recording::Covariates::winding_temperature_C,
                                              "winding temperature (winding_temperature_C)"};

using Columns = std::vector<std::vector<double>>;

/// All that is known of an effect, as data. The texts and tables must outlive the program.
struct TensionDefinition {
  std::string_view id;
  std::string_view term;
  std::string_view equation;
  std::string_view life_consequence;
  std::span<const Parameter> parameters;
  std::span<const Separation> separations;
  std::span<const Need> needs = {};
  bool acts_on_current = false;  ///< changes T_in only where it comes from the current
  bool per_pose = false;
  bool at_reversals = false;
  bool shifts_sessions = false;
  std::vector<std::vector<double>> shapes = {{}};
  bool whole_shapes = false;  ///< nothing lies between them
  Columns (*columns)(const recording::Covariates& covariates, const Baseline& baseline,
                     std::span<const double> shape) = nullptr;
};

/// The catalogue by kinds of physics; a file each.
std::vector<TensionDefinition> friction_effects();
std::vector<TensionDefinition> transmission_effects();
std::vector<TensionDefinition> sensor_effects();  ///< and of the drive

}  // namespace host_sim::effects
