#include "tests/blind/generator/lives_design.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host_sim/reference/equations.hpp"

namespace blind {
namespace {

namespace reference = host_sim::reference;

constexpr std::size_t kLevels = 6;

void predict(const TrueLaw& law, LifeLevelDesign& level) {
  const double efficiency = reference::capstan_efficiency(
      law.friction_coefficient, level.bend_angle_deg * std::numbers::pi / 180);
  level.effective_N = reference::gerber_effective_tension(
      reference::input_tension_range({level.mean_N, level.amplitude_N}, efficiency),
      kUltimateTension_N);
  level.life_cycles =
      reference::ipl_life_cycles(level.effective_N, law.ipl_scale, law.ipl_exponent);
}

void draw_levels(std::size_t specimens, const TrueLaw& law, bool tell_ratio, Dice& dice,
                 LivesDesign& design) {
  const std::vector<double> bends_deg{dice.between(60, 120), dice.between(180, 240),
                                      dice.between(290, 330)};
  const double amplitude_N = dice.between(16, 20);
  const std::vector<double> means_N{amplitude_N + dice.between(0, 2),
                                    amplitude_N + dice.between(18, 24)};
  const std::vector<double> ratios{dice.between(0.025, 0.04), dice.between(0.06, 0.1)};
  for (std::size_t i = 0; i < kLevels; ++i) {
    LifeLevelDesign level;
    level.bend_angle_deg = bends_deg[i / 2];
    level.mean_N = means_N[i % 2];
    level.amplitude_N = amplitude_N;
    level.frequency_Hz = i % 3 == 0 ? 0.2 : 1;
    level.wire_to_bend_ratio = tell_ratio ? ratios[(i / 2 + i) % 2] : 0;
    level.specimens = specimens / kLevels + (i < specimens % kLevels ? 1 : 0);
    predict(law, level);
    level.suspend_at_cycles = std::round(level.life_cycles * dice.between(1.2, 5));
    design.levels.push_back(level);
  }
}

}  // namespace

LivesDesign draw_lives_design(std::size_t specimens, const std::vector<std::string_view>& hidden,
                              const TrueLaw& law, Dice& dice) {
  constexpr double kToldShare = 0.6;
  const auto hides = [&](std::string_view id) {
    return std::find(hidden.begin(), hidden.end(), id) != hidden.end();
  };
  LivesDesign design;
  design.lots = specimens < 96 ? 4 : 6;
  const bool tell_ratio = dice.chance(kToldShare) || hides("bending_fatigue");
  design.record_days = dice.chance(kToldShare) || hides("ageing");
  design.rigs = dice.chance(kToldShare) || hides("rig_bias") ? 2 : 1;
  design.storage_days =
      design.record_days ? std::vector<double>{1, 10, 30, 90, 200} : std::vector<double>{1};
  const std::size_t in_programs = specimens / 4;
  draw_levels(specimens - in_programs, law, tell_ratio, dice, design);
  const double share = dice.between(0.25, 0.5);
  const std::size_t low = 0;
  const std::size_t high = kLevels - 1;
  for (const auto& [first, second] : {std::pair{high, low}, std::pair{low, high}}) {
    design.programs.push_back(
        {first, second, std::round(share * design.levels[first].life_cycles), in_programs / 2});
  }
  return design;
}

}  // namespace blind
