#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "host_sim/extension/model_file.hpp"

namespace extension_test {

/// The paper's wire in a sheath of 270 deg, with a drive of 20.592 N for each ampere.
inline constexpr std::string_view kNominal = R"(schema = 1
[cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[drive]
torque_constant_Nm_per_A = 0.0325
gear_ratio = 9.0
gear_efficiency = 0.88
spool_radius_mm = 12.5
current_offset_A = 0.0
[counting]
sample_rate_Hz = 1000.0
hysteresis_N = 0.2
[life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
)";

/// That model with these tables behind it.
inline host_sim::Model model_with(std::string_view tables) {
  return host_sim::parse_extended_model(std::string(kNominal) + std::string(tables), "m.toml");
}

}  // namespace extension_test
