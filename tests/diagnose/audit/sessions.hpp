#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/audit/gram.hpp"

namespace host_sim::diagnose::testing {

/// How one recording was run.
struct Run {
  double bend_angle_rad = 3;
  double frequency_Hz = 0.5;  ///< of a stroke of 40 mm
  double mean_N = 60;
  double sheath_C = 21;  ///< at the start, rising by `warming_C`
  double winding_C = 30;
  double start_cycle = 0;
  double warming_C = 1;
  double duration_s = 10;
};

inline constexpr double kRate_Hz = 50;
inline constexpr double kMu = 0.128;

/// Covariates by formula: position 20 mm sin(2 pi f t), input tension swinging by 40 % at 1.37 f,
/// temperatures rising evenly, current 1 A for 21 N. T_out is what the baseline makes of T_in.
Session session_of(const std::string& name, const Run& run);

/// Sessions of these runs, named s0, s1 and so on.
std::vector<Session> sessions_of(const std::vector<Run>& runs);

/// 36 runs: three bend angles, two speeds, two loads, three sheath temperatures, in a shuffled
/// order so that cycle number and winding temperature go with none of them.
std::vector<Run> crossed();

/// Nine runs of one pose, speed and load at room temperature, at rising cycle number.
std::vector<Run> one_pose();

effects::Baseline baseline();

}  // namespace host_sim::diagnose::testing
