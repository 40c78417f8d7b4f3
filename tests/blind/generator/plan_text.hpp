#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/blind/generator/scenario.hpp"

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

/// The drive of all campaigns that have one.
inline constexpr double kGearEfficiency = 0.88;
inline constexpr double kRatedTorque_Nm = 4 * 0.0325;
inline constexpr double kFullScale_A = 8;

/// The head of a plan with its model; `mu` is the true one.
std::string model_text(const Scenario& scenario, double mu);

std::string recordings_text(const Scenario& scenario, const RecordingsDesign& design);

/// Noise of sensors, and scatter of sessions up to half as much again as was measured.
std::string noise_text(Input input, std::uint64_t seed);

/// What every analysis of recordings refits.
NominalFactors nominal_friction_and_drive(std::uint64_t seed);

}  // namespace blind
