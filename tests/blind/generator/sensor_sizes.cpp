#include <vector>

#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

HiddenEffect current_offset(const Situation& situation, Dice& dice) {
  const double share = dice.log_between(0.001, 0.02);
  return {
      "current_offset", false, {{"offset_A", {dice.sign() * share * situation.full_scale_A}}}, {}};
}

HiddenEffect torque_gain(const Situation& /*situation*/, Dice& dice) {
  return {"torque_gain",
          false,
          {{"error", {dice.between(-0.01, 0.01)}},
           {"droop_1_K", {dice.log_between(0.0003, 0.002)}},
           {"reference_C", {20}}},
          {}};
}

/// Half the difference of the two efficiencies, in proportion, up to twice that of a gear of
/// 89.0 and 85.3 %.
HiddenEffect gear_asymmetry(const Situation& situation, Dice& dice) {
  const double share = dice.sign() * dice.log_between(0.005, 0.04);
  return {"gear_asymmetry",
          false,
          {{"pulling_efficiency", {situation.gear_efficiency * (1 + share)}},
           {"releasing_efficiency", {situation.gear_efficiency * (1 - share)}}},
          {}};
}

HiddenEffect torque_ripple(const Situation& situation, Dice& dice) {
  const double share = dice.log_between(0.005, 0.05);
  return {"torque_ripple",
          false,
          {{"amplitude_Nm", {share * situation.rated_torque_Nm}},
           {"periods_per_turn", {dice.one_of<double>({1, 2, 4, 6, 7, 12})}},
           {"phase_deg", {dice.between(0, 360)}}},
          {}};
}

HiddenEffect filter_lag(const Situation& situation, Dice& dice) {
  const char* const at_drive =
      situation.input == Input::load_cell ? "input_tension" : "motor_current";
  return {"filter_lag",
          false,
          {{"time_constant_ms", {dice.log_between(1, 20)}}},
          {{"sensor", dice.chance(0.5) ? "output_tension" : at_drive}}};
}

}  // namespace

std::span<const SizedEffect> sensor_effects() {
  static const std::vector<SizedEffect> effects{
      {"current_offset", Needs::motor_current, current_offset},
      {"filter_lag", Needs::any_input, filter_lag},
      {"gear_asymmetry", Needs::motor_current, gear_asymmetry},
      {"torque_gain", Needs::motor_current, torque_gain},
      {"torque_ripple", Needs::motor_current, torque_ripple}};
  return effects;
}

}  // namespace blind
