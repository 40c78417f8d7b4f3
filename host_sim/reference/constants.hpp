#pragma once

namespace host_sim::reference {

/// Constants of a wire and of its life, all finite. The paper's wire: 177.4 N, A 1.53e5,
/// gamma 1.38, beta 5.94.
struct Constants {
  double ultimate_tension_N;  ///< T_u > 0
  double hysteresis_N;        ///< >= 0; smaller swings are not counted
  double ipl_scale;           ///< A > 0, cycles * N^gamma
  double ipl_exponent;        ///< gamma > 0
  double weibull_shape;       ///< beta > 0
};

}  // namespace host_sim::reference
