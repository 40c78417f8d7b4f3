#include "host_sim/effects/counting/damage.hpp"

#include <vector>

#include "host_sim/reference/reference.hpp"

namespace host_sim::effects {
namespace {

double damage_of(const std::vector<double>& tension_N, std::size_t step,
                 const reference::Constants& constants) {
  reference::Reference count(constants);
  for (std::size_t i = 0; i < tension_N.size(); i += step) {
    count.push(tension_N[i]);
  }
  return count.reading().damage.total;
}

}  // namespace

std::string missing_input(const recording::Covariates& covariates) {
  return covariates.tension_in_N().empty() ? "no input tension (input_tension_N or motor_current_A)"
                                           : "";
}

double share_lost(const recording::Covariates& covariates, reference::Constants constants,
                  std::size_t step, double hysteresis_N) {
  const std::vector<double>& tension_N = covariates.tension_in_N();
  constants.hysteresis_N = 0;
  const double full = damage_of(tension_N, 1, constants);
  constants.hysteresis_N = hysteresis_N;
  return full > 0 ? (full - damage_of(tension_N, step, constants)) / full : 0;
}

}  // namespace host_sim::effects
