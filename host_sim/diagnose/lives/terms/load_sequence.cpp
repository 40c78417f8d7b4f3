#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {

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

}  // namespace host_sim::diagnose::lives
