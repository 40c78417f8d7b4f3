#include "host_sim/diagnose/lives/terms.hpp"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace host_sim::diagnose::lives {
namespace {

/// The same within narrower bounds.
TermParameter within(TermParameter parameter, double minimum, double maximum, double typical) {
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  const double share = (typical - minimum) / (maximum - minimum);
  parameter.centre = std::log(share / (1 - share));
  return parameter;
}

std::vector<Term> ageing_terms(const LifeSample&) {
  const effects::LifeEffect& effect = life_effect("ageing");
  constexpr double kSpread = 1.5;
  return {{.id = "ageing",
           .parameters = {parameter_of(effect, "ageing_1_day", kSpread)},
           .apply = [](std::span<const double> values, LifeSettings& settings) {
             settings.ageing_1_day = values[0];
           }}};
}

/// The bending acts on the amplitude alone, as the catalogue has it, or on the mean too, as the
/// bending of a wire that is straight between does.
std::vector<Term> bending_fatigue_terms(const LifeSample&) {
  const effects::LifeEffect& effect = life_effect("bending_fatigue");
  constexpr double kSpread = 1.2;
  std::vector<Term> terms;
  for (const bool from_zero : {false, true}) {
    terms.push_back({.id = "bending_fatigue",
                     .ln_weight = std::log(0.5),
                     .parameters = {parameter_of(effect, "bending_N", kSpread)},
                     .apply =
                         [from_zero](std::span<const double> values, LifeSettings& settings) {
                           settings.bending_N = values[0];
                           settings.bending_from_zero = from_zero;
                         },
                     .of_catalogue = [](std::span<const double> values,
                                        const LifeSettings&) -> std::vector<double> {
                       return {1, values[0]};
                     }});
  }
  return terms;
}

/// A limit below all levels bends the line; one among them leaves specimens that never fail.
std::vector<Term> endurance_limit_terms(const LifeSample& sample) {
  const effects::LifeEffect& effect = life_effect("endurance_limit");
  constexpr double kSpread = 1.2;
  const double lowest_N = sample.lowest_N;
  return {{.id = "endurance_limit",
           .parameters = {parameter_of(effect, "limit_log_sd", kSpread),
                          parameter_of(effect, "limit_of_lowest", kSpread)},
           .apply =
               [lowest_N](std::span<const double> values, LifeSettings& settings) {
                 settings.limit_log_sd = values[0];
                 settings.limit_N = values[1] * lowest_N;
               },
           .of_catalogue = [](std::span<const double> values,
                              const LifeSettings&) -> std::vector<double> {
             return {1, values[0], values[1]};
           },
           .companions = {{"lowest_effective_N", {lowest_N}}}}};
}

std::vector<Term> load_sequence_terms(const LifeSample&) {
  const effects::LifeEffect& effect = life_effect("load_sequence");
  constexpr double kSpread = 1;
  return {{.id = "load_sequence",
           .parameters = {parameter_of(effect, "sequence_exponent", kSpread)},
           .apply = [](std::span<const double> values,
                       LifeSettings& settings) { settings.sequence_exponent = values[0]; },
           .of_catalogue = [](std::span<const double> values,
                              const LifeSettings&) -> std::vector<double> {
             return {1, values[0]};
           }}};
}

std::vector<Term> lot_frailty_terms(const LifeSample&) {
  const effects::LifeEffect& effect = life_effect("lot_frailty");
  constexpr double kSpread = 1;
  return {{.id = "lot_frailty",
           .parameters = {parameter_of(effect, "lot_log_sd", kSpread)},
           .apply = [](std::span<const double> values, LifeSettings& settings) {
             settings.lot_log_sd = values[0];
           }}};
}

/// Walker's law, Smith, Watson and Topper's among it, and Goodman's.
std::vector<Term> mean_stress_terms(const LifeSample& sample) {
  const effects::LifeEffect& effect = life_effect("mean_stress");
  constexpr double kSpread = 0.8;
  constexpr double kWalkerShare = 2.0 / 3;
  std::vector<Term> terms{
      {.id = "mean_stress",
       .ln_weight = std::log(kWalkerShare),
       .law = "Walker",
       .words = "mean-stress law: Walker's in place of Gerber's",
       .parameters = {parameter_of(effect, "walker_exponent", kSpread)},
       .apply = [](std::span<const double> values,
                   LifeSettings& settings) { settings.walker_exponent = values[0]; },
       .of_catalogue = [](std::span<const double> values,
                          const LifeSettings&) -> std::vector<double> {
         return {1, values[0]};
       }}};
  if (std::isfinite(sample.ultimate_tension_N)) {
    terms.push_back(
        {.id = "mean_stress",
         .ln_weight = std::log(1 - kWalkerShare),
         .law = "Goodman",
         .words = "mean-stress law: Goodman's in place of Gerber's",
         .apply = [](std::span<const double>,
                     LifeSettings& settings) { settings.walker_exponent = 0; },
         .of_catalogue = [](std::span<const double>, const LifeSettings&) -> std::vector<double> {
           return {1, 0};
         }});
  }
  return terms;
}

struct SecondModeForm {
  bool from_top = true;
  std::size_t reached = 1;  ///< levels
  double steepness = 0;
  double weight = 0;  ///< among the forms
};

Term second_mode_term(const effects::LifeEffect& effect, const LifeSample& sample,
                      const SecondModeForm& form, double ln_weight) {
  constexpr double kSpread = 1;
  constexpr double kShiftSpread = 0.6;
  LifeSettings::SecondMode mode;
  mode.steepness = form.steepness;
  mode.first_level = form.from_top ? sample.levels - form.reached : 0;
  mode.last_level = form.from_top ? sample.levels - 1 : form.reached - 1;
  mode.end_N = form.from_top ? sample.highest_N : sample.lowest_N;
  constexpr double kShift = 2;
  const double levels = form.from_top ? 1.0 : -1.0;
  const double reach = form.steepness > 0 ? 2 : static_cast<double>(form.reached);
  return {.id = "second_mode",
          .ln_weight = ln_weight,
          .parameters = {within(parameter_of(effect, "log_life_shift", kShiftSpread), -kShift,
                                kShift, 0),
                         parameter_of(effect, "second_log_sd", kSpread)},
          .apply =
              [mode](std::span<const double> values, LifeSettings& settings) {
                settings.second_mode = mode;
                settings.second_mode->log_life_shift = values[0];
                settings.second_mode->shape = kLogLifeSd / values[1];
              },
          .of_catalogue = [levels, reach](std::span<const double> values,
                                          const LifeSettings&) -> std::vector<double> {
            return {values[0], values[1], levels * reach, 0};
          }};
}

/// Each specimen has one mode or the other, so that the lives of one load fall into two groups. A
/// smaller part of the specimens than the bounds allow is one that died early, of anything.
Term second_group_term(const effects::LifeEffect& effect, const LifeSample& sample) {
  constexpr double kSpread = 1;
  constexpr double kUsualShift = -1.5;
  constexpr double kLeastShare = 0.2;
  LifeSettings::SecondMode mode;
  mode.end_N = sample.highest_N;
  const TermParameter shift = parameter_of(effect, "log_life_shift", kSpread);
  return {.id = "second_mode",
          .words = "second failure mode of a part of the specimens",
          .parameters = {within(shift, shift.minimum, 0, kUsualShift),
                         parameter_of(effect, "second_log_sd", kSpread),
                         within(parameter_of(effect, "second_share", kSpread), kLeastShare,
                                1 - kLeastShare, 0.5)},
          .apply =
              [mode](std::span<const double> values, LifeSettings& settings) {
                settings.second_mode = mode;
                settings.second_mode->log_life_shift = values[0];
                settings.second_mode->shape = kLogLifeSd / values[1];
                settings.second_mode->share = values[2];
              },
          .of_catalogue = [](std::span<const double> values,
                             const LifeSettings&) -> std::vector<double> {
            return {values[0], values[1], 1, values[2]};
          }};
}

/// Of lives at one level: the mode shows in their shape alone.
std::vector<Term> second_mode_terms_of_one_level(const LifeSample& sample) {
  const effects::LifeEffect& effect = life_effect("second_mode");
  std::vector<Term> terms{second_mode_term(effect, sample, {.weight = 0.5}, std::log(0.5)),
                          second_group_term(effect, sample)};
  terms.back().ln_weight = std::log(0.5);
  return terms;
}

/// A mode on a line of its own fades away from one end of the levels by its steepness, or it
/// reaches some levels and no more. High loads are where a mode is expected first.
std::vector<Term> second_mode_terms(const LifeSample& sample) {
  if (sample.levels == 1) {
    return second_mode_terms_of_one_level(sample);
  }
  constexpr double kFromTop = 0.7;
  constexpr double kWeightOfReach[] = {0.35, 0.2};
  constexpr double kWeightOfSteepness = 0.15;
  const effects::LifeEffect& effect = life_effect("second_mode");
  std::vector<SecondModeForm> forms;
  for (const bool from_top : {true, false}) {
    const double weight = from_top ? kFromTop : 1 - kFromTop;
    for (std::size_t reached = 1; reached <= 2 && reached < sample.levels; ++reached) {
      forms.push_back({from_top, reached, 0, weight * kWeightOfReach[reached - 1]});
    }
    for (const double steepness : {1.0, 2.5, 6.0}) {
      forms.push_back({from_top, sample.levels, steepness, weight * kWeightOfSteepness});
    }
  }
  std::vector<Term> terms;
  terms.reserve(forms.size());
  for (const SecondModeForm& form : forms) {
    terms.push_back(second_mode_term(effect, sample, form, std::log(form.weight)));
  }
  return terms;
}

}  // namespace

double TermParameter::value(double u) const {
  const double at = centre + spread * u;
  return bounded ? minimum + (maximum - minimum) / (1 + std::exp(-at)) : at;
}

TermParameter parameter_of(const effects::LifeEffect& effect, std::string_view name,
                           double spread) {
  for (const effects::Parameter& parameter : effect.parameters()) {
    if (parameter.name == name) {
      const double share =
          (parameter.typical - parameter.minimum) / (parameter.maximum - parameter.minimum);
      return {.name = std::string(name),
              .unit = std::string(parameter.unit),
              .bounded = true,
              .minimum = parameter.minimum,
              .maximum = parameter.maximum,
              .centre = std::log(share / (1 - share)),
              .spread = spread};
    }
  }
  throw std::out_of_range("no parameter " + std::string(name));
}

TermParameter shift(std::string name, double sd) {
  return {.name = std::move(name), .unit = "1", .centre = 0, .spread = sd};
}

const effects::LifeEffect& life_effect(std::string_view id) {
  for (const auto& effect : effects::life_effects()) {
    if (effect->id() == id) {
      return *effect;
    }
  }
  throw std::out_of_range("no effect " + std::string(id));
}

std::vector<Term> terms_of(const std::string& effect, const LifeSample& sample) {
  using Make = std::vector<Term> (*)(const LifeSample&);
  static const std::map<std::string, Make> makes{{"ageing", ageing_terms},
                                                 {"bending_fatigue", bending_fatigue_terms},
                                                 {"endurance_limit", endurance_limit_terms},
                                                 {"load_sequence", load_sequence_terms},
                                                 {"lot_frailty", lot_frailty_terms},
                                                 {"mean_stress", mean_stress_terms},
                                                 {"second_mode", second_mode_terms}};
  return makes.at(effect)(sample);
}

}  // namespace host_sim::diagnose::lives
