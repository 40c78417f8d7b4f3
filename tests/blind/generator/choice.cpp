#include "tests/blind/generator/choice.hpp"

#include <algorithm>
#include <iterator>
#include <span>

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
SizedEffect partner_of(const std::vector<SizedEffect>& effects, const std::vector<SizedEffect>& all,
                       Dice& dice) {
  std::vector<SizedEffect> partners;
  std::copy_if(all.begin(), all.end(), std::back_inserter(partners), [&](const SizedEffect& other) {
    return std::all_of(effects.begin(), effects.end(), [&](const SizedEffect& one) {
      return other.id != one.id && go_together(one, other);
    });
  });
  return dice.one_of(partners);
}

std::size_t count_of(CampaignKind kind) {
  switch (kind) {
    case CampaignKind::none:
      return 0;
    case CampaignKind::one:
    case CampaignKind::outside:
      break;
    case CampaignKind::two:
      return 2;
    case CampaignKind::three:
      return 3;
  }
  return 1;
}

std::vector<SizedEffect> draw_effects(CampaignKind kind, const std::vector<SizedEffect>& all,
                                      const std::vector<SizedEffect>& outside, Dice& dice) {
  if (kind == CampaignKind::none) {
    return {};
  }
  if (kind == CampaignKind::outside) {
    return {dice.one_of(outside)};
  }
  std::vector<SizedEffect> effects{dice.one_of(all)};
  while (effects.size() < count_of(kind)) {
    effects.push_back(partner_of(effects, all, dice));
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

/// From outside of the catalogue, with those that are held back from tuning.
std::vector<SizedEffect> outside_for(std::uint64_t seed, std::span<const SizedEffect> known,
                                     std::span<const SizedEffect> held_back) {
  std::vector<SizedEffect> all(known.begin(), known.end());
  if (seed >= kFirstScoringSeed) {
    all.insert(all.end(), held_back.begin(), held_back.end());
  }
  return all;
}

/// Of campaigns with two, a third get one more.
CampaignKind with_three(CampaignKind kind, Dice& dice) {
  return dice.chance(1.0 / 3) && kind == CampaignKind::two ? CampaignKind::three : kind;
}

}  // namespace

CampaignKind draw_kind(Dice& dice) {
  constexpr double kNone = 0.2;
  constexpr double kOne = 0.45;
  constexpr double kTwo = 0.15;
  const double place = dice.between(0, 1);
  return place < kNone                 ? CampaignKind::none
         : place < kNone + kOne        ? CampaignKind::one
         : place < kNone + kOne + kTwo ? CampaignKind::two
                                       : CampaignKind::outside;
}

Choice choose(std::uint64_t seed) {
  Dice dice(seed, Purpose::kind);
  Dice effects(seed, Purpose::effects);
  Choice choice;
  choice.kind = draw_kind(dice);
  choice.design = dice.chance(kOnePoseShare) ? Design::one_pose : Design::crossed;
  const bool current = dice.chance(0.5);
  const bool temperatures = dice.chance(kTemperaturesShare);
  choice.kind = with_three(choice.kind, dice);
  choice.effects = draw_effects(choice.kind, catalogue(),
                                outside_for(seed, outside_effects(), held_back_effects()), effects);
  choice.input = any_needs(choice.effects, Needs::load_cell)       ? Input::load_cell
                 : any_needs(choice.effects, Needs::motor_current) ? Input::motor_current
                 : current                                         ? Input::motor_current
                                                                   : Input::load_cell;
  choice.temperatures = temperatures || any_of_temperature(choice.effects);
  return choice;
}

Choice choose_two_sided(std::uint64_t seed) {
  Dice dice(seed, Purpose::kind);
  Dice effects(seed, Purpose::effects);
  const auto all = two_sided_effects();
  Choice choice;
  choice.design = Design::two_sided;
  choice.kind = draw_kind(dice);
  choice.input = dice.chance(0.5) ? Input::motor_current : Input::load_cell;
  choice.kind = with_three(choice.kind, dice);
  choice.effects = draw_effects(
      choice.kind, {all.begin(), all.end()},
      outside_for(seed, outside_two_sided_effects(), held_back_two_sided_effects()), effects);
  return choice;
}

}  // namespace blind
