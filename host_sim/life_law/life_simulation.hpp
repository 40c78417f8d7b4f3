#pragma once

#include <span>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/statistics/bootstrap.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::life_law {

/// Draws campaigns like one that was measured: the same loads and plan of suspension.
class LifeSimulation {
 public:
  explicit LifeSimulation(std::span<const LifeDatum> data);

  /// Lives under `law`, into `drawn`. Specimens at a level follow the plan of that level: its
  /// suspensions, inspections and dropped lives. A specimen in blocks that failed continues in its
  /// last block until it fails; one that was suspended is suspended at the end of its blocks unless
  /// it fails before.
  void draw(const LifeLaw& law, statistics::Random& random, LifeData& drawn) const;

 private:
  struct LevelPlan {
    std::vector<std::size_t> specimens;
    statistics::CensoringPlan plan;
  };
  LifeData data_;
  std::vector<LevelPlan> levels_;
};

}  // namespace host_sim::life_law
