#include <cmath>

#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// Standard deviation of ln N of a Weibull life, times its shape: pi / sqrt(6).
constexpr double kLogLifeSd = 1.2825498301618641;

struct Form {
  bool from_top = true;
  std::size_t reached = 1;  ///< levels
  double steepness = 0;
  double weight = 0;  ///< among the forms
};

Term term_of(const effects::LifeEffect& effect, const LifeSample& sample, const Form& form,
             double ln_weight) {
  constexpr double kSpread = 1;
  constexpr double kShiftSpread = 0.6;
  LifeSettings::SecondMode mode;
  mode.steepness = form.steepness;
  mode.first_level = form.from_top ? sample.levels - form.reached : 0;
  mode.last_level = form.from_top ? sample.levels - 1 : form.reached - 1;
  mode.end_N = form.from_top ? sample.highest_N : sample.lowest_N;
  TermParameter shift = parameter_of(effect, "log_life_shift", kShiftSpread);
  shift.centre = 0;
  const double levels = form.from_top ? 1.0 : -1.0;
  const double reach = form.steepness > 0 ? 2 : static_cast<double>(form.reached);
  return {.id = "second_mode",
          .ln_weight = ln_weight,
          .parameters = {shift, parameter_of(effect, "second_log_sd", kSpread)},
          .apply =
              [mode](std::span<const double> values, LifeSettings& settings) {
                settings.second_mode = mode;
                settings.second_mode->log_life_shift = values[0];
                settings.second_mode->shape = kLogLifeSd / values[1];
              },
          .of_catalogue = [levels, reach](std::span<const double> values,
                                          const LifeSettings&) -> std::vector<double> {
            return {values[0], values[1], levels * reach};
          }};
}

}  // namespace

/// A mode on a line of its own fades away from one end of the levels by its steepness, or it
/// reaches some levels and no more. High loads are where a mode is expected first.
std::vector<Term> second_mode_terms(const LifeSample& sample) {
  constexpr double kFromTop = 0.7;
  constexpr double kWeightOfReach[] = {0.35, 0.2};
  constexpr double kWeightOfSteepness = 0.15;
  const effects::LifeEffect& effect = life_effect("second_mode");
  std::vector<Form> forms;
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
  for (const Form& form : forms) {
    terms.push_back(term_of(effect, sample, form, std::log(form.weight)));
  }
  return terms;
}

}  // namespace host_sim::diagnose::lives
