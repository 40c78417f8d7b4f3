#include "host_sim/plan/design.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numeric>

namespace host_sim::plan {
namespace {

/// (c / alpha)^beta, the cumulative hazard at suspension.
double hazard_at(double cycles, double effective_tension_N, const LifeLaw& law) {
  return std::pow(cycles / law.characteristic_life(effective_tension_N), law.shape);
}

}  // namespace

std::size_t Design::specimens() const {
  return std::accumulate(
      levels.begin(), levels.end(), std::size_t{0},
      [](std::size_t sum, const PlannedLevel& level) { return sum + level.specimens; });
}

std::size_t Design::tested_levels() const {
  return static_cast<std::size_t>(std::count_if(
      levels.begin(), levels.end(), [](const PlannedLevel& level) { return level.specimens > 0; }));
}

double expected_failures(const PlannedLevel& level, double suspend_at_cycles, const LifeLaw& law) {
  const double hazard = hazard_at(suspend_at_cycles, level.effective_tension_N, law);
  return static_cast<double>(level.specimens) * -std::expm1(-hazard);
}

double expected_cycles(const PlannedLevel& level, double suspend_at_cycles, const LifeLaw& law) {
  const auto specimens = static_cast<double>(level.specimens);
  if (std::isinf(suspend_at_cycles)) {
    return specimens * law.mean_life(level.effective_tension_N);
  }
  // The integral of the survival up to the suspension.
  const double hazard = hazard_at(suspend_at_cycles, level.effective_tension_N, law);
  return specimens * law.characteristic_life(level.effective_tension_N) / law.shape *
         boost::math::tgamma_lower(1 / law.shape, hazard);
}

}  // namespace host_sim::plan
