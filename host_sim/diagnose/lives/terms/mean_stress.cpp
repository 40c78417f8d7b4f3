#include <cmath>

#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {

/// Walker's law, Smith, Watson and Topper's among it, and Goodman's.
std::vector<Term> mean_stress_terms(const LifeSample& sample) {
  const effects::LifeEffect& effect = life_effect("mean_stress");
  constexpr double kSpread = 0.8;
  constexpr double kWalkerShare = 2.0 / 3;
  std::vector<Term> terms{
      {.id = "mean_stress",
       .ln_weight = std::log(kWalkerShare),
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
         .apply = [](std::span<const double>,
                     LifeSettings& settings) { settings.walker_exponent = 0; },
         .of_catalogue = [](std::span<const double>, const LifeSettings&) -> std::vector<double> {
           return {1, 0};
         }});
  }
  return terms;
}

}  // namespace host_sim::diagnose::lives
