#include "tests/blind/generator/choice.hpp"

#include <algorithm>
#include <iterator>

namespace blind {
namespace {

constexpr double kOnePoseShare = 0.15;
constexpr double kTemperaturesShare = 0.7;

std::vector<SizedEffect> catalogue() {
  std::vector<SizedEffect> all;
  for (const auto group : {friction_effects(), transmission_effects(), sensor_effects()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

bool go_together(const SizedEffect& one, const SizedEffect& other) {
  return one.needs == other.needs || one.needs == Needs::any_input ||
         other.needs == Needs::any_input;
}

/// Another effect that the same campaign can show.
SizedEffect partner_of(const SizedEffect& one, Dice& dice) {
  std::vector<SizedEffect> partners;
  const std::vector<SizedEffect> all = catalogue();
  std::copy_if(all.begin(), all.end(), std::back_inserter(partners), [&](const SizedEffect& other) {
    return other.id != one.id && go_together(one, other);
  });
  return dice.one_of(partners);
}

std::vector<SizedEffect> draw_effects(CampaignKind kind, Dice& dice) {
  if (kind == CampaignKind::none) {
    return {};
  }
  if (kind == CampaignKind::outside) {
    const auto all = outside_effects();
    return {dice.one_of(std::vector<SizedEffect>(all.begin(), all.end()))};
  }
  std::vector<SizedEffect> effects{dice.one_of(catalogue())};
  if (kind == CampaignKind::two) {
    effects.push_back(partner_of(effects.front(), dice));
  }
  return effects;
}

bool any_needs(const std::vector<SizedEffect>& effects, Needs needs) {
  return std::any_of(effects.begin(), effects.end(),
                     [&](const SizedEffect& effect) { return effect.needs == needs; });
}

bool any_of_temperature(const std::vector<SizedEffect>& effects) {
  return std::any_of(effects.begin(), effects.end(), [](const SizedEffect& effect) {
    return effect.id == "friction_temperature" || effect.id == "torque_gain" ||
           effect.id == "load_cell_thermal_lag";
  });
}

}  // namespace

double share_of(CampaignKind kind) {
  switch (kind) {
    case CampaignKind::none:
      return 0.2;
    case CampaignKind::one:
      return 0.45;
    case CampaignKind::two:
      return 0.15;
    case CampaignKind::outside:
      return 0.2;
  }
  return 0;
}

CampaignKind draw_kind(Dice& dice) {
  double left = dice.between(0, 1);
  for (const CampaignKind kind : {CampaignKind::none, CampaignKind::one, CampaignKind::two}) {
    left -= share_of(kind);
    if (left < 0) {
      return kind;
    }
  }
  return CampaignKind::outside;
}

Choice choose(std::uint64_t seed) {
  Dice dice(seed, Purpose::kind);
  Dice effects(seed, Purpose::effects);
  Choice choice;
  choice.kind = draw_kind(dice);
  choice.design = dice.chance(kOnePoseShare) ? Design::one_pose : Design::crossed;
  choice.effects = draw_effects(choice.kind, effects);
  const bool current = dice.chance(0.5);
  choice.input = any_needs(choice.effects, Needs::load_cell)       ? Input::load_cell
                 : any_needs(choice.effects, Needs::motor_current) ? Input::motor_current
                 : current                                         ? Input::motor_current
                                                                   : Input::load_cell;
  choice.temperatures = dice.chance(kTemperaturesShare) || any_of_temperature(choice.effects);
  return choice;
}

}  // namespace blind
