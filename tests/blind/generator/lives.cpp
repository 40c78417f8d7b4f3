#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

#include "host_sim/reference/equations.hpp"
#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {
namespace {

/// The true law of lives: A, gamma and beta of (19) and (20).
struct TrueLaw {
  double friction_coefficient = 0;
  double ipl_scale = 0, ipl_exponent = 0, weibull_shape = 0;
};

inline constexpr double kUltimateTension_N = 177.4;

struct LifeLevelDesign {
  double bend_angle_deg = 0, mean_N = 0, amplitude_N = 0, frequency_Hz = 0;
  double wire_to_bend_ratio = 0;  ///< 0 where it is not recorded
  double effective_N = 0;         ///< by the nominal model
  double life_cycles = 0;         ///< alpha at that tension
  double suspend_at_cycles = 0;
  std::size_t specimens = 0;
};

/// Two steps: a level for some cycles, then another until failure.
struct LifeProgramDesign {
  std::size_t first = 0, second = 0;  ///< places of levels
  double cycles = 0;
  std::size_t specimens = 0;
};

struct LivesDesign {
  std::size_t lots = 1, rigs = 1;
  std::vector<double> storage_days;
  bool record_days = false;
  std::vector<LifeLevelDesign> levels;
  std::vector<LifeProgramDesign> programs;
};

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

/// Three bends crossed with two mean tensions of one amplitude, wires that bend more or less, and
/// programs from high to low and from low to high; a quarter of the specimens has a program.
/// @param hidden ids of what is hidden, so that the plan records what they need
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

struct LifeScales {
  const TrueLaw& law;
  const LifeLevelDesign& lowest;
  const LifeLevelDesign& highest;
};

struct SizedLifeEffect {
  std::string_view id;
  bool outside;
  HiddenEffect (*draw)(const LifeScales& scales, Dice& dice);
};

HiddenEffect ageing(const LifeScales& /*scales*/, Dice& dice) {
  return {"ageing", false, {{"rate_1_day", {dice.log_between(0.001, 0.01)}}}, {}};
}

HiddenEffect bending_fatigue(const LifeScales& /*scales*/, Dice& dice) {
  return {"bending_fatigue",
          false,
          {{"metal_area_mm2", {0.09}}, {"share", {dice.log_between(0.01, 0.05)}}},
          {}};
}

HiddenEffect endurance_limit(const LifeScales& scales, Dice& dice) {
  return {"endurance_limit",
          false,
          {{"limit_N", {scales.lowest.effective_N * dice.between(0.45, 0.85)}},
           {"log_sd", {dice.between(0, 0.1)}}},
          {}};
}

HiddenEffect load_sequence(const LifeScales& /*scales*/, Dice& dice) {
  return {"load_sequence", false, {{"exponent", {dice.between(0.2, 0.5)}}}, {}};
}

HiddenEffect lot_frailty(const LifeScales& /*scales*/, Dice& dice) {
  return {"lot_frailty", false, {{"log_sd", {dice.log_between(0.1, 0.4)}}}, {}};
}

HiddenEffect mean_stress(const LifeScales& /*scales*/, Dice& dice) {
  const std::size_t law = dice.below(3);
  HiddenEffect effect{"mean_stress", false, {}, {}};
  effect.texts["law"] = std::array{"walker", "goodman", "swt"}[law];
  if (law == 0) {
    effect.numbers["walker_exponent"] = {dice.between(0.4, 0.8)};
  }
  return effect;
}

/// A mode that ends about as many specimens of the highest level as the first one does, and fewer
/// below it; its shape is that of the paper's 540 deg or less.
HiddenEffect second_mode(const LifeScales& scales, Dice& dice) {
  return {"second_mode",
          false,
          {{"life_cycles", {scales.highest.life_cycles * dice.log_between(0.5, 1)}},
           {"reference_N", {scales.highest.effective_N}},
           {"exponent", {scales.law.ipl_exponent + dice.between(2.5, 5)}},
           {"shape", {dice.between(2, 3.5)}}},
          {}};
}

HiddenEffect rig_bias(const LifeScales& /*scales*/, Dice& dice) {
  return {"rig_bias", true, {{"share", {dice.log_between(0.1, 0.35)}}}, {}};
}

HiddenEffect early_deaths(const LifeScales& /*scales*/, Dice& dice) {
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

/// Ids of the effects of the catalogue, and of departures that it does not have.
std::vector<std::string_view> life_effects() {
  return ids(false);
}

std::vector<std::string_view> outside_life_effects() {
  return ids(true);
}

/// An effect of a size within its physical range.
/// @param lowest, highest the least and the most loaded level
HiddenEffect draw_life_effect(std::string_view id, const TrueLaw& law,
                              const LifeLevelDesign& lowest, const LifeLevelDesign& highest,
                              Dice& dice) {
  const auto* const effect =
      std::find_if(kEffects.begin(), kEffects.end(),
                   [&](const SizedLifeEffect& candidate) { return candidate.id == id; });
  return effect->draw({law, lowest, highest}, dice);
}

std::vector<std::string_view> draw_ids(CampaignKind kind, Dice& dice) {
  if (kind == CampaignKind::none) {
    return {};
  }
  std::vector<std::string_view> all =
      kind == CampaignKind::outside ? outside_life_effects() : life_effects();
  std::vector<std::string_view> ids{dice.one_of(all)};
  if (kind == CampaignKind::two) {
    std::erase(all, ids.front());
    ids.push_back(dice.one_of(all));
  }
  return ids;
}

std::string model_text(std::uint64_t seed, const TrueLaw& law) {
  return "schema = 1\n" + table("campaign") + line("name", "blind-" + std::to_string(seed)) +
         table("model.cable") + line("diameter_mm", 0.457) +
         line("ultimate_tension_N", kUltimateTension_N) + table("model.sheath") +
         line("friction_coefficient", law.friction_coefficient) + line("bend_angle_deg", 270.0) +
         table("model.life") + line("mean_stress", "gerber") + line("ipl_scale", law.ipl_scale) +
         line("ipl_exponent", law.ipl_exponent) + line("weibull_shape", law.weibull_shape);
}

std::string level_text(const LifeLevelDesign& level) {
  std::string text = "\n[[lives.level]]\n" + line("bend_angle_deg", level.bend_angle_deg) +
                     line("output_tension_mean_N", level.mean_N) +
                     line("output_tension_amplitude_N", level.amplitude_N) +
                     line("frequency_Hz", level.frequency_Hz) +
                     line("specimens", static_cast<double>(level.specimens)) +
                     line("suspend_at_cycles", level.suspend_at_cycles);
  return level.wire_to_bend_ratio > 0 ? text + line("wire_to_bend_ratio", level.wire_to_bend_ratio)
                                      : text;
}

std::string program_text(const LifeProgramDesign& program) {
  return "\n[[lives.program]]\n" +
         line("levels", std::vector{static_cast<double>(program.first + 1),
                                    static_cast<double>(program.second + 1)}) +
         line("cycles", std::vector{program.cycles}) +
         line("specimens", static_cast<double>(program.specimens));
}

std::string lives_text(const LivesDesign& design) {
  std::string text = table("lives") + line("lots", static_cast<double>(design.lots)) +
                     line("rigs", static_cast<double>(design.rigs)) +
                     line("storage_days", design.storage_days) +
                     "record_days = " + (design.record_days ? "true" : "false") + "\n";
  for (const LifeLevelDesign& level : design.levels) {
    text += level_text(level);
  }
  for (const LifeProgramDesign& program : design.programs) {
    text += program_text(program);
  }
  return text;
}

TrueLaw draw_law(Dice& dice) {
  return {dice.between(0.1, 0.14), dice.log_between(1e5, 2.2e5), dice.between(1.2, 1.6),
          dice.between(4, 7)};
}

NominalFactors nominal_law(std::uint64_t seed) {
  Dice dice(seed, Purpose::nominal);
  NominalFactors factors;
  factors.ipl_scale = dice.log_between(0.8, 1.25);
  factors.ipl_exponent = dice.between(0.93, 1.07);
  factors.weibull_shape = dice.log_between(0.8, 1.25);
  return factors;
}

}  // namespace

Scenario draw_lives(std::uint64_t seed, std::uint64_t attempt) {
  Dice kinds(seed, Purpose::kind);
  Dice effects(seed, Purpose::effects);
  Dice designs(seed, Purpose::design, attempt);
  Dice sizes(seed, Purpose::sizes, attempt);
  Scenario scenario;
  scenario.seed = seed;
  scenario.data = Data::lives;
  scenario.kind = draw_kind(kinds);
  scenario.specimens = kinds.chance(0.5) ? 48 : 96;
  scenario.nominal = nominal_law(seed);
  const std::vector<std::string_view> ids = draw_ids(scenario.kind, effects);
  const TrueLaw law = draw_law(designs);
  const LivesDesign design = draw_lives_design(scenario.specimens, ids, law, designs);
  scenario.plan = model_text(seed, law) + lives_text(design);
  const auto [lowest, highest] =
      std::minmax_element(design.levels.begin(), design.levels.end(),
                          [](const LifeLevelDesign& one, const LifeLevelDesign& other) {
                            return one.effective_N < other.effective_N;
                          });
  for (const std::string_view id : ids) {
    scenario.hidden.push_back(draw_life_effect(id, law, *lowest, *highest, sizes));
    scenario.plan += table_of(scenario.hidden.back());
  }
  return scenario;
}

}  // namespace blind
