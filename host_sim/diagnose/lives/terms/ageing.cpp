#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {

std::vector<Term> ageing_terms(const LifeSample&) {
  const effects::LifeEffect& effect = life_effect("ageing");
  constexpr double kSpread = 1.5;
  return {{.id = "ageing",
           .parameters = {parameter_of(effect, "ageing_1_day", kSpread)},
           .apply = [](std::span<const double> values, LifeSettings& settings) {
             settings.ageing_1_day = values[0];
           }}};
}

}  // namespace host_sim::diagnose::lives
