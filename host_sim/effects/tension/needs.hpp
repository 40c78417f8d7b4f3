#pragma once

#include "host_sim/effects/tension/definition.hpp"

/// The covariates that signatures read, with what to record for them.
namespace host_sim::effects {

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

}  // namespace host_sim::effects
