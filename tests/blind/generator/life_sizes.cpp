#include "tests/blind/generator/life_sizes.hpp"

#include <algorithm>
#include <array>

namespace blind {
namespace {

struct LifeSituation {
  const TrueLaw& law;
  const LifeLevelDesign& lowest;
  const LifeLevelDesign& highest;
};

struct SizedLifeEffect {
  std::string_view id;
  bool outside;
  HiddenEffect (*draw)(const LifeSituation& situation, Dice& dice);
};

HiddenEffect ageing(const LifeSituation& /*situation*/, Dice& dice) {
  return {"ageing", false, {{"rate_1_day", {dice.log_between(0.001, 0.01)}}}, {}};
}

HiddenEffect bending_fatigue(const LifeSituation& /*situation*/, Dice& dice) {
  return {"bending_fatigue",
          false,
          {{"metal_area_mm2", {0.09}}, {"share", {dice.log_between(0.01, 0.05)}}},
          {}};
}

HiddenEffect endurance_limit(const LifeSituation& situation, Dice& dice) {
  return {"endurance_limit",
          false,
          {{"limit_N", {situation.lowest.effective_N * dice.between(0.45, 0.85)}},
           {"log_sd", {dice.between(0, 0.1)}}},
          {}};
}

HiddenEffect load_sequence(const LifeSituation& /*situation*/, Dice& dice) {
  return {"load_sequence", false, {{"exponent", {dice.between(0.2, 0.5)}}}, {}};
}

HiddenEffect lot_frailty(const LifeSituation& /*situation*/, Dice& dice) {
  return {"lot_frailty", false, {{"log_sd", {dice.log_between(0.1, 0.4)}}}, {}};
}

HiddenEffect mean_stress(const LifeSituation& /*situation*/, Dice& dice) {
  const std::size_t law = dice.below(3);
  HiddenEffect effect{"mean_stress", false, {}, {}};
  effect.words["law"] = std::array{"walker", "goodman", "swt"}[law];
  if (law == 0) {
    effect.numbers["walker_exponent"] = {dice.between(0.4, 0.8)};
  }
  return effect;
}

/// A mode that ends about as many specimens of the highest level as the first one does, and fewer
/// below it; its shape is that of the paper's 540 deg or less.
HiddenEffect second_mode(const LifeSituation& situation, Dice& dice) {
  return {"second_mode",
          false,
          {{"life_cycles", {situation.highest.life_cycles * dice.log_between(0.5, 1)}},
           {"reference_N", {situation.highest.effective_N}},
           {"exponent", {situation.law.ipl_exponent + dice.between(2.5, 5)}},
           {"shape", {dice.between(2, 3.5)}}},
          {}};
}

HiddenEffect rig_bias(const LifeSituation& /*situation*/, Dice& dice) {
  return {"rig_bias", true, {{"share", {dice.log_between(0.1, 0.35)}}}, {}};
}

HiddenEffect early_deaths(const LifeSituation& /*situation*/, Dice& dice) {
  return {"early_deaths",
          true,
          {{"share", {dice.between(0.06, 0.25)}}, {"life_left", {dice.log_between(0.03, 0.3)}}},
          {}};
}

constexpr std::array<SizedLifeEffect, 9> kEffects{{
    {"ageing", false, ageing},
    {"bending_fatigue", false, bending_fatigue},
    {"endurance_limit", false, endurance_limit},
    {"load_sequence", false, load_sequence},
    {"lot_frailty", false, lot_frailty},
    {"mean_stress", false, mean_stress},
    {"second_mode", false, second_mode},
    {"early_deaths", true, early_deaths},
    {"rig_bias", true, rig_bias},
}};

std::vector<std::string_view> ids(bool outside) {
  std::vector<std::string_view> found;
  for (const SizedLifeEffect& effect : kEffects) {
    if (effect.outside == outside) {
      found.push_back(effect.id);
    }
  }
  return found;
}

}  // namespace

std::vector<std::string_view> life_effects() {
  return ids(false);
}

std::vector<std::string_view> outside_life_effects() {
  return ids(true);
}

HiddenEffect draw_life_effect(std::string_view id, const TrueLaw& law,
                              const LifeLevelDesign& lowest, const LifeLevelDesign& highest,
                              Dice& dice) {
  const auto* const effect =
      std::find_if(kEffects.begin(), kEffects.end(),
                   [&](const SizedLifeEffect& candidate) { return candidate.id == id; });
  return effect->draw({law, lowest, highest}, dice);
}

}  // namespace blind
