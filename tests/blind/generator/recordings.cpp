#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/plan_text.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

constexpr double kRoom_C = 20;

void draw_motion(const Choice& choice, Dice& dice, RecordingsDesign& design) {
  const bool must_sway =
      std::any_of(choice.effects.begin(), choice.effects.end(),
                  [](const SizedEffect& effect) { return effect.id == "load_cell_cross_talk"; });
  design.load_frequency_ratio = dice.between(1.15, 1.85);
  design.load_phase_deg = dice.between(0, 360);
  design.constant_speed = dice.chance(0.25);
  if (dice.chance(0.2) || must_sway) {
    design.pose_sway_deg = dice.between(5, 20);
    design.pose_sway_Hz = dice.between(0.1, 0.4);
  }
  design.sample_rate_Hz = dice.chance(0.5) ? 100 : 200;
  design.duration_s = std::round(dice.between(8, 20));
}

void draw_crossed(const Choice& choice, Dice& dice, RecordingsDesign& design) {
  design.sessions = 12 + dice.below(25);
  design.bend_angles_deg = {dice.between(60, 100), dice.between(160, 240), dice.between(300, 390)};
  design.output_means_N = {dice.between(12, 20), dice.between(30, 40)};
  design.output_amplitudes_N = {dice.between(2, 5), dice.between(7, 11)};
  design.frequencies_Hz = {dice.between(0.2, 0.4), dice.between(0.7, 1.2), dice.between(1.6, 2.5)};
  design.travels_mm = {dice.between(15, 25), dice.between(35, 50)};
  design.start_cycles = {0, dice.between(300, 700), dice.between(1500, 3000),
                         dice.between(6000, 10000)};
  design.sheath_ambients_C = {kRoom_C};
  design.winding_starts_C = {kRoom_C};
  if (choice.temperatures) {
    design.sheath_ambients_C.push_back(dice.between(40, 55));
    design.winding_starts_C.push_back(dice.between(60, 90));
  }
}

void draw_one_pose(Dice& dice, RecordingsDesign& design) {
  design.sessions = 12 + dice.below(25);
  design.bend_angles_deg = {dice.between(180, 300)};
  design.travels_mm = {dice.between(25, 45)};
  const double cycles_between = dice.between(200, 500);
  const double warmer_K = dice.between(5, 20);
  const std::vector<double> frequencies_Hz{dice.between(0.3, 0.6), dice.between(0.8, 1.5)};
  for (std::size_t i = 0; i < design.sessions; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(design.sessions - 1);
    design.start_cycles.push_back(std::round(static_cast<double>(i) * cycles_between));
    design.sheath_ambients_C.push_back(kRoom_C + warmer_K * share + dice.between(-1, 1));
    design.winding_starts_C.push_back(dice.between(20, 60));
    design.output_means_N.push_back(dice.between(20, 35));
    design.output_amplitudes_N.push_back(dice.between(4, 12));
    design.frequencies_Hz.push_back(dice.one_of(frequencies_Hz));
  }
}

double middle_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double most_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// 12 .. 36 sessions of 8 .. 20 s. Crossed: two or three poses, loads, speeds, temperatures and
/// cycles, dealt out apart from each other. In one pose: one session after the other in a tendon's
/// life, warmer from month to month.
RecordingsDesign draw_design(const Choice& choice, std::uint64_t seed) {
  Dice dice(seed, Purpose::design);
  RecordingsDesign design;
  draw_motion(choice, dice, design);
  if (choice.design == Design::crossed) {
    draw_crossed(choice, dice, design);
  } else {
    draw_one_pose(dice, design);
  }
  return design;
}

/// What the design says about sizes; what it does not know stays.
void add_to(TensionScales& scales, const RecordingsDesign& design) {
  scales.mean_tension_N = middle_of(design.output_means_N);
  scales.shortest_travel_mm = *std::min_element(design.travels_mm.begin(), design.travels_mm.end());
  scales.last_cycle = most_of(design.start_cycles);
  scales.fastest_m_s =
      std::numbers::pi * most_of(design.frequencies_Hz) * most_of(design.travels_mm) * 1e-3;
  scales.fastest_m_s2 = 2 * std::numbers::pi * most_of(design.frequencies_Hz) * scales.fastest_m_s;
  scales.poses = design.bend_angles_deg.size();
}

}  // namespace

Scenario draw_recordings(std::uint64_t seed) {
  const Choice choice = choose(seed);
  Scenario scenario;
  scenario.seed = seed;
  scenario.kind = choice.kind;
  scenario.design = choice.design;
  scenario.input = choice.input;
  scenario.temperatures = choice.temperatures;
  scenario.nominal = nominal_friction_and_drive(seed);
  const RecordingsDesign design = draw_design(choice, seed);
  Dice dice(seed, Purpose::sizes);
  TensionScales scales;
  scales.input = choice.input;
  scales.friction_coefficient = dice.between(0.09, 0.15);
  scales.gear_efficiency = kGearEfficiency;
  scales.rated_torque_Nm = kRatedTorque_Nm;
  scales.full_scale_A = kFullScale_A;
  add_to(scales, design);
  scenario.plan = model_text(scenario, scales.friction_coefficient) +
                  recordings_text(scenario, design) + noise_text(choice.input, seed);
  for (const SizedEffect& effect : choice.effects) {
    scenario.hidden.push_back(effect.draw(scales, dice));
    scenario.plan += table_of(scenario.hidden.back());
  }
  return scenario;
}

}  // namespace blind
