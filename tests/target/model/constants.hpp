#pragma once

#include <numbers>

#include "lifemodel/pack/pack.hpp"

namespace target {

/// The model of the paper: 0.457 mm wire, 270 deg of bend; 1 kHz, hysteresis 0.2 N.
inline constexpr lifemodel::pack::Constants kPaperModel{
    .ultimate_tension_N = 177.4,
    .hysteresis_N = 0.2,
    .ipl_scale = 1.53e5,
    .ipl_exponent = 1.38,
    .weibull_shape = 5.94,
    .friction_coefficient = 0.128,
    .bend_angle_rad = 1.5 * std::numbers::pi,
    .tension_per_current_N_A = 0.0325 * 9.0 * 0.88 / 0.0125,
    .current_offset_A = 0.0,
    .sample_period_s = 1e-3,
    .model_digest = 0x54455354,
};

}  // namespace target
