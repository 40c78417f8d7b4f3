#include <cmath>

#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {

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

}  // namespace host_sim::diagnose::lives
