#include <vector>

#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

HiddenEffect presliding(const Situation& /*situation*/, Dice& dice) {
  return {"presliding", false, {{"length_mm", {dice.log_between(0.05, 1)}}}, {}};
}

HiddenEffect slack(const Situation& /*situation*/, Dice& dice) {
  return {"slack",
          false,
          {{"dead_zone_mm", {dice.log_between(0.1, 2)}}, {"held_share", {dice.between(0.3, 0.95)}}},
          {}};
}

/// Stiffness of a metre or two of thin wire in its sheath.
HiddenEffect compliance(const Situation& /*situation*/, Dice& dice) {
  return {"compliance", false, {{"stiffness_N_mm", {dice.log_between(15, 300)}}}, {}};
}

/// An error of its own for each pose; one of them is the largest, 5 .. 30 deg.
HiddenEffect bend_angle(const Situation& situation, Dice& dice) {
  const double largest_deg = dice.log_between(5, 30);
  std::vector<double> errors_deg(situation.poses);
  for (double& error_deg : errors_deg) {
    error_deg = largest_deg * dice.between(-1, 1);
  }
  errors_deg[dice.below(errors_deg.size())] = dice.sign() * largest_deg;
  return {"bend_angle", false, {{"error_deg", errors_deg}}, {}};
}

}  // namespace

std::span<const SizedEffect> transmission_effects() {
  static const std::vector<SizedEffect> effects{{"bend_angle", Needs::any_input, bend_angle},
                                                {"compliance", Needs::any_input, compliance},
                                                {"presliding", Needs::any_input, presliding},
                                                {"slack", Needs::any_input, slack}};
  return effects;
}

}  // namespace blind
