#pragma once

#include <cstdint>
#include <vector>

#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/situation.hpp"

namespace blind {

/// What sessions are run at, as [recordings] of a plan has it.
struct RecordingsDesign {
  std::size_t sessions = 0;
  std::vector<double> bend_angles_deg, output_means_N, output_amplitudes_N, frequencies_Hz,
      travels_mm, sheath_ambients_C, winding_starts_C, start_cycles;
  double load_frequency_ratio = 1, load_phase_deg = 0;
  double pose_sway_deg = 0, pose_sway_Hz = 0.1;
  bool constant_speed = false;
  double sample_rate_Hz = 0, duration_s = 0;
};

/// 12 .. 36 sessions of 8 .. 20 s. Crossed: two or three poses, loads, speeds, temperatures and
/// cycles, dealt out apart from each other. In one pose: one session after the other in a tendon's
/// life, warmer from month to month.
RecordingsDesign draw_design(const Choice& choice, std::uint64_t seed);

/// What the design says about sizes; what it does not know stays.
void add_to(Situation& situation, const RecordingsDesign& design);

}  // namespace blind
