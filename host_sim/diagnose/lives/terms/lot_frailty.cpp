#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {

std::vector<Term> lot_frailty_terms(const LifeSample&) {
  const effects::LifeEffect& effect = life_effect("lot_frailty");
  constexpr double kSpread = 1;
  return {{.id = "lot_frailty",
           .parameters = {parameter_of(effect, "lot_log_sd", kSpread)},
           .apply = [](std::span<const double> values, LifeSettings& settings) {
             settings.lot_log_sd = values[0];
           }}};
}

}  // namespace host_sim::diagnose::lives
