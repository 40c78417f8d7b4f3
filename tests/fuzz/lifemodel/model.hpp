#pragma once

#include "lifemodel/pack/pack.hpp"

namespace fuzz {

inline lifemodel::pack::Constants paper_constants() {
  return {.ultimate_tension_N = 177.4,
          .hysteresis_N = 0,
          .ipl_scale = 1.53e5,
          .ipl_exponent = 1.38,
          .weibull_shape = 5.94,
          .friction_coefficient = 0.128,
          .bend_angle_rad = 4.7,
          .tension_per_current_N_A = 20.6,
          .current_offset_A = 0,
          .sample_period_s = 1e-3,
          .model_digest = 1};
}

inline lifemodel::Parameters paper_model() {
  return *lifemodel::pack::parameters(paper_constants());
}

}  // namespace fuzz
