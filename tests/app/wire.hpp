#pragma once

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/pack/pack.hpp"

namespace app {

/// The paper's wire, sampled at 1 kHz. `ipl_scale` less than 1.53e5 makes it live shorter.
inline lifemodel::Parameters paper_parameters(double ipl_scale = 1.53e5) {
  return *lifemodel::pack::parameters({.ultimate_tension_N = 177.4,
                                       .hysteresis_N = 0.2,
                                       .ipl_scale = ipl_scale,
                                       .ipl_exponent = 1.38,
                                       .weibull_shape = 5.94,
                                       .friction_coefficient = 0.128,
                                       .bend_angle_rad = 4.712,
                                       .tension_per_current_N_A = 20.592,
                                       .current_offset_A = 0,
                                       .sample_period_s = 1e-3,
                                       .model_digest = 1});
}

/// n * 2^-exponent lives.
inline lifemodel::Damage lives(std::uint32_t n, int exponent) {
  lifemodel::Damage damage;
  lifemodel::Flags flags;
  damage.add({1u << 31, lifemodel::Damage::kFractionBits - 31 - exponent}, n, flags);
  return damage;
}

}  // namespace app
