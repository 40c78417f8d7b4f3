#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/audit/gram.hpp"
#include "host_sim/effects/tension/force_record.hpp"

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

/// By formula: position 20 mm sin(2 pi f t), input force swinging by 40 % at 1.37 f, temperatures
/// rising evenly, a motor of 21 N/A whose rotor turns 720 rad/m. T_out is what the Capstan law of
/// kMu makes of T_in.
effects::ForceRecord record_of(const std::string& name, const Run& run);

/// Records of these runs, named s0, s1 and so on.
std::vector<effects::ForceRecord> records_of(const std::vector<Run>& runs);

/// 36 runs: three bend angles, two speeds, two loads, three sheath temperatures, in a shuffled
/// order so that cycle number and winding temperature go with none of them.
std::vector<Run> crossed();

/// Nine runs of one pose, speed and load at room temperature, at rising cycle number.
std::vector<Run> one_pose();

/// 1 % of each input force, and sessions that scatter by as much in gain and by 0.006 in friction.
NoiseModel usual_noise(const std::vector<effects::ForceRecord>& records);

}  // namespace host_sim::diagnose::testing
