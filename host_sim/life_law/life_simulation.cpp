#include "host_sim/life_law/life_simulation.hpp"

#include <cmath>
#include <map>

namespace host_sim::life_law {
namespace {

/// Damage at which a specimen fails.
double drawn_damage(const LifeLaw& law, statistics::Random& random) {
  return std::pow(-std::log(random.uniform()), 1 / law.shape);
}

bool follows_plan(const LifeDatum& datum) {
  return datum.level != LifeDatum::kNoLevel && datum.blocks.size() == 1;
}

statistics::CensoringPlan plan_of(const LifeData& data, const std::vector<std::size_t>& specimens) {
  statistics::Sample sample;
  for (const std::size_t i : specimens) {
    sample.push_back(data[i].observation());
  }
  return statistics::CensoringPlan(sample);
}

/// Loads `specimen` with its blocks until it fails at `damage`; one that failed before continues in
/// its last block.
void load_in_blocks(const LifeLaw& law, double damage, LifeDatum& specimen) {
  const bool goes_on = specimen.failed;
  for (std::size_t j = 0; j < specimen.blocks.size(); ++j) {
    LifeDatum::Block& block = specimen.blocks[j];
    const double left_cycles = damage * law.characteristic_life(block.effective_tension_N);
    const bool last = j + 1 == specimen.blocks.size();
    if (left_cycles <= block.cycles || (last && goes_on)) {
      block.cycles = left_cycles;
      specimen.blocks.resize(j + 1);
      specimen.failed = true;
      return;
    }
    damage -= block.cycles / law.characteristic_life(block.effective_tension_N);
  }
  specimen.failed = false;
}

}  // namespace

LifeSimulation::LifeSimulation(std::span<const LifeDatum> data) : data_(data.begin(), data.end()) {
  std::map<std::size_t, std::vector<std::size_t>> specimens_of_levels;
  for (std::size_t i = 0; i < data_.size(); ++i) {
    if (follows_plan(data_[i])) {
      specimens_of_levels[data_[i].level].push_back(i);
    }
  }
  for (const auto& [level, specimens] : specimens_of_levels) {
    levels_.push_back({.specimens = specimens, .plan = plan_of(data_, specimens)});
  }
}

void LifeSimulation::draw(const LifeLaw& law, statistics::Random& random, LifeData& drawn) const {
  drawn = data_;
  std::vector<double> lives;
  statistics::Sample seen;
  for (const LevelPlan& level : levels_) {
    lives.clear();
    for (const std::size_t i : level.specimens) {
      const double alpha = law.characteristic_life(data_[i].blocks.front().effective_tension_N);
      lives.push_back(alpha * drawn_damage(law, random));
    }
    level.plan.observe(lives, random, seen);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      drawn[level.specimens[i]].observe(seen[i]);
    }
  }
  for (LifeDatum& specimen : drawn) {
    if (!follows_plan(specimen)) {
      load_in_blocks(law, drawn_damage(law, random), specimen);
    }
  }
}

}  // namespace host_sim::life_law
