#pragma once

#include "tests/blind/generator/scenario.hpp"

namespace blind::test {

/// Three short sessions with a sheath that wears.
inline Scenario small_scenario() {
  Scenario scenario;
  scenario.seed = 7;
  scenario.kind = Kind::one;
  scenario.hidden.push_back({"friction_wear",
                             false,
                             {{"change", {0.3}}, {"reference_cycles", {1000}}, {"exponent", {1}}},
                             {{"law", "wear"}}});
  scenario.nominal.friction_coefficient = 1.25;
  scenario.plan = R"(
[campaign]
name = "small"
[model.sheath]
friction_coefficient = 0.1
bend_angle_deg = 270.0
[recordings]
bend_angles_deg = 180.0
output_means_N = 30.0
output_amplitudes_N = 10.0
frequencies_Hz = 1.0
travels_mm = 40.0
start_cycles = [0.0, 500.0, 1000.0]
sample_rate_Hz = 50.0
duration_s = 2.0
channels = ["input_tension_N", "output_tension_N", "tendon_velocity_m_s", "bend_angle_deg"]
[noise]
log_tension_sd = 0.01
[effects.friction_wear]
change = 0.3
reference_cycles = 1000.0
exponent = 1.0
)";
  return scenario;
}

}  // namespace blind::test
