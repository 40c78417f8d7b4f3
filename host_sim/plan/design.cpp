#include "host_sim/plan/design.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numeric>

#include "host_sim/statistics/random.hpp"

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

Truth truth_under(const LifeLaw& law, const Design& design) {
  Truth truth{{}, law.shape};
  for (const PlannedLevel& level : design.levels) {
    truth.characteristic_life_cycles.push_back(law.characteristic_life(level.effective_tension_N));
  }
  return truth;
}

life_law::LifeData simulated_campaign(const Design& design, const Truth& truth, std::uint64_t seed,
                                      std::uint64_t number) {
  life_law::LifeData campaign;
  campaign.reserve(design.specimens());
  for (std::size_t i = 0; i < design.levels.size(); ++i) {
    const PlannedLevel& level = design.levels[i];
    statistics::Random random(seed, i, number);
    for (std::size_t k = 0; k < level.specimens; ++k) {
      const double life = truth.characteristic_life_cycles[i] *
                          std::pow(-std::log(random.uniform()), 1 / truth.shape);
      campaign.push_back({.blocks = {{.effective_tension_N = level.effective_tension_N,
                                      .cycles = std::min(life, design.suspend_at_cycles)}},
                          .failed = life <= design.suspend_at_cycles,
                          .level = i});
    }
  }
  return campaign;
}

}  // namespace host_sim::plan
