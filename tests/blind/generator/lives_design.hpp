#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "tests/blind/generator/dice.hpp"

namespace blind {

/// The true law of lives: A, gamma and beta of (19) and (20).
struct TrueLaw {
  double friction_coefficient = 0;
  double ipl_scale = 0, ipl_exponent = 0, weibull_shape = 0;
};

inline constexpr double kUltimateTension_N = 177.4;

struct LifeLevelDesign {
  double bend_angle_deg = 0, mean_N = 0, amplitude_N = 0, frequency_Hz = 0;
  double wire_to_bend_ratio = 0;  ///< 0 where it is not told
  double effective_N = 0;         ///< by the nominal model
  double life_cycles = 0;         ///< alpha at that tension
  double suspend_at_cycles = 0;
  std::size_t specimens = 0;
};

/// Two steps: a level for some cycles, then another until failure.
struct LifeProgramDesign {
  std::size_t first = 0, second = 0;  ///< places of levels
  double cycles = 0;
  std::size_t specimens = 0;
};

struct LivesDesign {
  std::size_t lots = 1, rigs = 1;
  std::vector<double> storage_days;
  bool record_days = false;
  std::vector<LifeLevelDesign> levels;
  std::vector<LifeProgramDesign> programs;
};

/// Three bends crossed with two mean tensions of one amplitude, wires that bend more or less, and
/// programs from high to low and from low to high; a quarter of the specimens has a program.
/// @param hidden ids of what is hidden, so that the plan tells what they need
LivesDesign draw_lives_design(std::size_t specimens, const std::vector<std::string_view>& hidden,
                              const TrueLaw& law, Dice& dice);

}  // namespace blind
