#include <vector>

#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

/// A share of mu by which it rises, or falls by half at most.
double change_of_friction(double least, double most, Dice& dice) {
  return dice.chance(0.7) ? dice.log_between(least, most) : -dice.log_between(least, 0.5);
}

HiddenEffect friction_wear(const Situation& situation, Dice& dice) {
  if (dice.chance(0.35)) {
    return {"friction_wear",
            false,
            {{"change", {dice.log_between(0.1, 1)}},
             {"reference_cycles", {situation.last_cycle / dice.between(4, 20)}}},
            {{"law", "run_in"}}};
  }
  return {"friction_wear",
          false,
          {{"change", {change_of_friction(0.1, 1, dice)}},
           {"reference_cycles", {situation.last_cycle}},
           {"exponent", {dice.between(0.5, 1)}}},
          {{"law", "wear"}}};
}

HiddenEffect friction_temperature(const Situation& /*situation*/, Dice& dice) {
  return {"friction_temperature",
          false,
          {{"slope_1_K", {dice.sign() * dice.log_between(0.001, 0.005)}}, {"reference_C", {20}}},
          {}};
}

/// Stribeck's fall, viscous rise, or both.
HiddenEffect friction_velocity(const Situation& situation, Dice& dice) {
  const double mu = situation.friction_coefficient;
  const std::size_t law = dice.below(3);
  const double rise = dice.log_between(0.15, 1);
  const double viscous = mu * dice.log_between(0.15, 2) / situation.fastest_m_s;
  return {"friction_velocity",
          false,
          {{"static_coefficient", {law == 1 ? mu : mu * (1 + rise)}},
           {"stribeck_velocity_mm_s", {dice.log_between(5, 50)}},
           {"viscous_s_m", {law == 0 ? 0.0 : viscous}}},
          {}};
}

HiddenEffect friction_load(const Situation& situation, Dice& dice) {
  const double sign = dice.chance(0.8) ? 1 : -1;
  return {"friction_load",
          false,
          {{"exponent", {sign * dice.log_between(0.05, 0.3)}},
           {"reference_N", {situation.mean_tension_N}}},
          {}};
}

HiddenEffect friction_preload(const Situation& /*situation*/, Dice& dice) {
  return {"friction_preload", false, {{"force_N", {dice.log_between(0.3, 5)}}}, {}};
}

HiddenEffect friction_position(const Situation& situation, Dice& dice) {
  return {"friction_position",
          false,
          {{"change", {change_of_friction(0.15, 1, dice)}},
           {"centre_mm", {dice.between(-0.35, 0.35) * situation.shortest_travel_mm}},
           {"width_mm", {dice.between(0.1, 0.3) * situation.shortest_travel_mm}}},
          {}};
}

}  // namespace

std::span<const SizedEffect> friction_effects() {
  static const std::vector<SizedEffect> effects{
      {"friction_load", Needs::any_input, friction_load},
      {"friction_position", Needs::any_input, friction_position},
      {"friction_preload", Needs::any_input, friction_preload},
      {"friction_temperature", Needs::any_input, friction_temperature},
      {"friction_velocity", Needs::any_input, friction_velocity},
      {"friction_wear", Needs::any_input, friction_wear}};
  return effects;
}

}  // namespace blind
