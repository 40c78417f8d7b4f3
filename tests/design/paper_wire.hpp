#pragma once

#include "host_sim/design/design.hpp"

namespace host_sim_test {

/// The wire, the sheath and the law of the paper.
inline host_sim::Model paper_model() {
  return {.cable = {.diameter_mm = 0.457, .ultimate_tension_N = 177.4},
          .sheath = {.friction_coefficient = 0.128, .bend_angle_deg = 270},
          .drive = {},
          .counting = {.sample_rate_Hz = 200, .hysteresis_N = 0.2},
          .life = {host_sim::Model::MeanStress::kGerber, 1.53e5, 1.38, 5.94}};
}

/// 49 N that hang at the end of a sheath bent by 270 degrees, as in section 3.
inline host_sim::design::Tendon paper_tendon() {
  return {.bend_angle_deg = 270,
          .friction_coefficient = 0.128,
          .output_max_N = 49,
          .output_min_N = 49,
          .diameter_mm = 0.457};
}

}  // namespace host_sim_test
