#include <vector>

#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

/// A share of mu by which it rises, or falls by half at most.
double change_of_friction(double least, double most, Dice& dice) {
  return dice.chance(0.7) ? dice.log_between(least, most) : -dice.log_between(least, 0.5);
}

HiddenEffect friction_wear(const TensionScales& scales, Dice& dice) {
  if (dice.chance(0.35)) {
    return {"friction_wear",
            false,
            {{"change", {dice.log_between(0.1, 1)}},
             {"reference_cycles", {scales.last_cycle / dice.between(4, 20)}}},
            {{"law", "run_in"}}};
  }
  return {"friction_wear",
          false,
          {{"change", {change_of_friction(0.1, 1, dice)}},
           {"reference_cycles", {scales.last_cycle}},
           {"exponent", {dice.between(0.5, 1)}}},
          {{"law", "wear"}}};
}

HiddenEffect friction_temperature(const TensionScales& /*scales*/, Dice& dice) {
  return {"friction_temperature",
          false,
          {{"slope_1_K", {dice.sign() * dice.log_between(0.001, 0.005)}}, {"reference_C", {20}}},
          {}};
}

/// Stribeck's fall, viscous rise, or both.
HiddenEffect friction_velocity(const TensionScales& scales, Dice& dice) {
  const double mu = scales.friction_coefficient;
  const std::size_t law = dice.below(3);
  const double rise = dice.log_between(0.15, 1);
  const double viscous = mu * dice.log_between(0.15, 2) / scales.fastest_m_s;
  return {"friction_velocity",
          false,
          {{"static_coefficient", {law == 1 ? mu : mu * (1 + rise)}},
           {"stribeck_velocity_mm_s", {dice.log_between(5, 50)}},
           {"viscous_s_m", {law == 0 ? 0.0 : viscous}}},
          {}};
}

HiddenEffect friction_load(const TensionScales& scales, Dice& dice) {
  const double sign = dice.chance(0.8) ? 1 : -1;
  return {"friction_load",
          false,
          {{"exponent", {sign * dice.log_between(0.05, 0.3)}},
           {"reference_N", {scales.mean_tension_N}}},
          {}};
}

HiddenEffect friction_preload(const TensionScales& /*scales*/, Dice& dice) {
  return {"friction_preload", false, {{"force_N", {dice.log_between(0.3, 5)}}}, {}};
}

HiddenEffect friction_position(const TensionScales& scales, Dice& dice) {
  return {"friction_position",
          false,
          {{"change", {change_of_friction(0.15, 1, dice)}},
           {"centre_mm", {dice.between(-0.35, 0.35) * scales.shortest_travel_mm}},
           {"width_mm", {dice.between(0.1, 0.3) * scales.shortest_travel_mm}}},
          {}};
}

/// From a fiftieth to a fifth of the stroke.
HiddenEffect presliding(const TensionScales& scales, Dice& dice) {
  const double share = dice.log_between(0.02, 0.2);
  return {"presliding", false, {{"length_mm", {share * scales.shortest_travel_mm}}}, {}};
}

HiddenEffect slack(const TensionScales& /*scales*/, Dice& dice) {
  return {"slack",
          false,
          {{"dead_zone_mm", {dice.log_between(0.1, 2)}}, {"held_share", {dice.between(0.3, 0.95)}}},
          {}};
}

/// Stiffness of a metre or two of thin wire in its sheath.
HiddenEffect compliance(const TensionScales& /*scales*/, Dice& dice) {
  return {"compliance", false, {{"stiffness_N_mm", {dice.log_between(15, 300)}}}, {}};
}

/// An error of its own for each pose; one of them is the largest, 5 .. 30 deg.
HiddenEffect bend_angle(const TensionScales& scales, Dice& dice) {
  const double largest_deg = dice.log_between(5, 30);
  std::vector<double> errors_deg(scales.poses);
  for (double& error_deg : errors_deg) {
    error_deg = largest_deg * dice.between(-1, 1);
  }
  errors_deg[dice.below(errors_deg.size())] = dice.sign() * largest_deg;
  return {"bend_angle", false, {{"error_deg", errors_deg}}, {}};
}

HiddenEffect current_offset(const TensionScales& scales, Dice& dice) {
  const double share = dice.log_between(0.001, 0.02);
  return {"current_offset", false, {{"offset_A", {dice.sign() * share * scales.full_scale_A}}}, {}};
}

HiddenEffect torque_gain(const TensionScales& /*scales*/, Dice& dice) {
  return {"torque_gain",
          false,
          {{"error", {dice.between(-0.01, 0.01)}},
           {"droop_1_K", {dice.log_between(0.0003, 0.002)}},
           {"reference_C", {20}}},
          {}};
}

/// Half the difference of the two efficiencies, in proportion, up to twice that of a gear of
/// 89.0 and 85.3 %.
HiddenEffect gear_asymmetry(const TensionScales& scales, Dice& dice) {
  const double share = dice.sign() * dice.log_between(0.005, 0.04);
  return {"gear_asymmetry",
          false,
          {{"pulling_efficiency", {scales.gear_efficiency * (1 + share)}},
           {"releasing_efficiency", {scales.gear_efficiency * (1 - share)}}},
          {}};
}

HiddenEffect torque_ripple(const TensionScales& scales, Dice& dice) {
  const double share = dice.log_between(0.005, 0.05);
  return {"torque_ripple",
          false,
          {{"amplitude_Nm", {share * scales.rated_torque_Nm}},
           {"periods_per_turn", {dice.one_of<double>({1, 2, 4, 6, 7, 12})}},
           {"phase_deg", {dice.between(0, 360)}}},
          {}};
}

HiddenEffect filter_lag(const TensionScales& scales, Dice& dice) {
  return of_either_sensor("filter_lag", "time_constant_ms", scales, dice);
}

}  // namespace

HiddenEffect of_either_sensor(const char* id, const char* key, const TensionScales& scales,
                              Dice& dice) {
  const char* const at_drive = scales.input == Input::load_cell ? "input_tension" : "motor_current";
  return {id,
          false,
          {{key, {dice.log_between(1, 20)}}},
          {{"sensor", dice.chance(0.5) ? "output_tension" : at_drive}}};
}

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

std::span<const SizedEffect> transmission_effects() {
  static const std::vector<SizedEffect> effects{{"bend_angle", Needs::any_input, bend_angle},
                                                {"compliance", Needs::any_input, compliance},
                                                {"presliding", Needs::any_input, presliding},
                                                {"slack", Needs::any_input, slack}};
  return effects;
}

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
