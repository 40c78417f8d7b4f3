#include "host_sim/plan/simulated_campaign.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/statistics/random.hpp"

namespace host_sim::plan {

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
