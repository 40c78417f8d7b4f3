#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {

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

}  // namespace host_sim::diagnose::lives
