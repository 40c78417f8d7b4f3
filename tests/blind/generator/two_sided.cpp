#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/plan_text.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

HiddenEffect one_number(const char* id, const char* key, double value, bool outside = false) {
  return {id, outside, {{key, {value}}}, {}};
}

HiddenEffect signed_velocity(const TensionScales& scales, Dice& dice) {
  const double share = dice.log_between(0.03, 0.3);
  return one_number("friction_velocity", "viscous_N_s_m",
                    share * scales.force_amplitude_N / scales.fastest_m_s);
}

HiddenEffect signed_presliding(const TensionScales& scales, Dice& dice) {
  return one_number("presliding", "length_mm",
                    dice.log_between(0.02, 0.2) * scales.shortest_travel_mm);
}

HiddenEffect signed_load(const TensionScales& scales, Dice& dice) {
  const double sign = dice.chance(0.8) ? 1 : -1;
  return {"friction_load",
          false,
          {{"exponent", {sign * dice.log_between(0.05, 0.3)}},
           {"reference_N", {scales.force_amplitude_N}}},
          {}};
}

HiddenEffect signed_preload(const TensionScales& scales, Dice& dice) {
  return one_number("friction_preload", "force_N",
                    dice.log_between(0.03, 0.3) * scales.force_amplitude_N);
}

HiddenEffect signed_position(const TensionScales& scales, Dice& dice) {
  return {
      "friction_position",
      false,
      {{"change", {dice.chance(0.7) ? dice.log_between(0.15, 1) : -dice.log_between(0.15, 0.5)}},
       {"centre_mm", {dice.between(-0.35, 0.35) * scales.shortest_travel_mm}},
       {"width_mm", {dice.between(0.1, 0.3) * scales.shortest_travel_mm}}},
      {}};
}

HiddenEffect signed_slack(const TensionScales& scales, Dice& dice) {
  return one_number("slack", "dead_zone_mm",
                    dice.log_between(0.02, 0.15) * scales.shortest_travel_mm);
}

/// The largest force stretches the tendon by 1 .. 10 % of the stroke.
HiddenEffect signed_compliance(const TensionScales& scales, Dice& dice) {
  return one_number(
      "compliance", "stiffness_N_mm",
      scales.force_amplitude_N / (dice.log_between(0.01, 0.1) * scales.shortest_travel_mm));
}

HiddenEffect signed_zero(const TensionScales& scales, Dice& dice) {
  return one_number("load_cell_zero", "zero_N",
                    dice.sign() * dice.log_between(0.01, 0.1) * scales.force_amplitude_N);
}

HiddenEffect signed_lag(const TensionScales& scales, Dice& dice) {
  return of_either_sensor("filter_lag", "time_constant_ms", scales, dice);
}

HiddenEffect signed_delay(const TensionScales& scales, Dice& dice) {
  return of_either_sensor("channel_delay", "delay_ms", scales, dice);
}

HiddenEffect signed_creep(const TensionScales& /*scales*/, Dice& dice) {
  return {"sheath_creep",
          true,
          {{"share", {dice.sign() * dice.log_between(0.03, 0.15)}},
           {"time_constant_s", {dice.log_between(2, 10)}}},
          {}};
}

HiddenEffect moving_mass(const TensionScales& scales, Dice& dice) {
  return one_number("moving_mass", "mass_kg",
                    dice.log_between(0.05, 0.5) * scales.force_amplitude_N / scales.fastest_m_s2,
                    true);
}

HiddenEffect one_way_friction(const TensionScales& /*scales*/, Dice& dice) {
  return one_number("one_way_friction", "share", dice.log_between(0.3, 1.5), true);
}

RecordingsDesign draw_design_of_two_sided(Dice& dice) {
  RecordingsDesign design;
  design.sessions = 12 + dice.below(13);
  design.bend_angles_deg = {dice.between(60, 120), dice.between(200, 360)};
  design.output_means_N = {dice.between(-8, 0), dice.between(0, 8)};
  design.output_amplitudes_N = {dice.between(15, 25), dice.between(40, 60)};
  design.frequencies_Hz = {dice.between(0.2, 0.4), dice.between(0.7, 1.2), dice.between(1.6, 2.5)};
  design.travels_mm = {dice.between(20, 35), dice.between(50, 80)};
  design.start_cycles = {0};
  design.sheath_ambients_C = {20};
  design.winding_starts_C = {20};
  design.load_frequency_ratio = dice.between(0.4, 1.85);
  design.load_phase_deg = dice.between(0, 360);
  design.constant_speed = dice.chance(0.25);
  design.sample_rate_Hz = dice.chance(0.5) ? 100 : 200;
  design.duration_s = std::round(dice.between(8, 20));
  return design;
}

TensionScales scales_of(const Choice& choice, const RecordingsDesign& design) {
  TensionScales scales;
  scales.input = choice.input;
  scales.force_amplitude_N = (design.output_amplitudes_N[0] + design.output_amplitudes_N[1]) / 2;
  scales.shortest_travel_mm = design.travels_mm.front();
  scales.fastest_m_s =
      std::numbers::pi * design.frequencies_Hz.back() * design.travels_mm.back() * 1e-3;
  scales.fastest_m_s2 = 2 * std::numbers::pi * design.frequencies_Hz.back() * scales.fastest_m_s;
  return scales;
}

}  // namespace

std::span<const SizedEffect> two_sided_effects() {
  static const std::vector<SizedEffect> effects{
      {"channel_delay", Needs::any_input, signed_delay},
      {"compliance", Needs::any_input, signed_compliance},
      {"filter_lag", Needs::any_input, signed_lag},
      {"friction_load", Needs::any_input, signed_load},
      {"friction_position", Needs::any_input, signed_position},
      {"friction_preload", Needs::any_input, signed_preload},
      {"friction_velocity", Needs::any_input, signed_velocity},
      {"load_cell_zero", Needs::any_input, signed_zero},
      {"presliding", Needs::any_input, signed_presliding},
      {"slack", Needs::any_input, signed_slack}};
  return effects;
}

std::span<const SizedEffect> outside_two_sided_effects() {
  static const std::vector<SizedEffect> effects{
      {"one_way_friction", Needs::any_input, one_way_friction},
      {"sheath_creep", Needs::any_input, signed_creep}};
  return effects;
}

std::span<const SizedEffect> held_back_two_sided_effects() {
  static const std::vector<SizedEffect> effects{{"moving_mass", Needs::any_input, moving_mass}};
  return effects;
}

Scenario draw_two_sided(std::uint64_t seed) {
  const Choice choice = choose_two_sided(seed);
  Scenario scenario;
  scenario.seed = seed;
  scenario.kind = choice.kind;
  scenario.design = choice.design;
  scenario.input = choice.input;
  scenario.nominal = nominal_friction_and_drive(seed);
  Dice of_design(seed, Purpose::design);
  const RecordingsDesign design = draw_design_of_two_sided(of_design);
  Dice dice(seed, Purpose::sizes);
  const double mu = dice.between(0.05, 0.15);
  const TensionScales scales = scales_of(choice, design);
  scenario.plan =
      model_text(scenario, mu) + recordings_text(scenario, design) + noise_text(choice.input, seed);
  for (const SizedEffect& effect : choice.effects) {
    scenario.hidden.push_back(effect.draw(scales, dice));
    scenario.plan += table_of(scenario.hidden.back());
  }
  return scenario;
}

}  // namespace blind
