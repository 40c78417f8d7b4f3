#include <algorithm>

#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/life_sizes.hpp"
#include "tests/blind/generator/lives_design.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/generator/toml_text.hpp"

namespace blind {
namespace {

std::vector<std::string_view> draw_ids(Kind kind, Dice& dice) {
  if (kind == Kind::none) {
    return {};
  }
  std::vector<std::string_view> all =
      kind == Kind::outside ? outside_life_effects() : life_effects();
  std::vector<std::string_view> ids{dice.one_of(all)};
  if (kind == Kind::two) {
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

NominalFactors draw_nominal(std::uint64_t seed) {
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
  scenario.nominal = draw_nominal(seed);
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
