#include "host_sim/synth/campaign/lives.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/life/catalogue.hpp"
#include "host_sim/synth/streams.hpp"

namespace host_sim::synth {
namespace {

std::unique_ptr<LifePart> make(const Hidden& hidden) {
  const auto kinds = hidden.outside ? outside_life_kinds() : life_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const LifeKind& candidate) {
    return candidate.id == hidden.id;
  });
  return kind->make(hidden.values);
}

std::vector<std::unique_ptr<LifePart>> parts_for(const SynthPlan& plan, const SpecimenPlace& place,
                                                 std::uint64_t seed) {
  std::vector<std::unique_ptr<LifePart>> parts;
  for (const Hidden& hidden : plan.hidden) {
    if (hidden.of_life) {
      parts.push_back(make(hidden));
      parts.back()->begin(place, seed);
    }
  }
  return parts;
}

/// Where specimens come from and run. Rigs take turns within a lot, so that neither hides the
/// other.
SpecimenPlace place_of(const LifePlan& plan, std::size_t number, std::size_t in_level,
                       std::size_t level) {
  SpecimenPlace place;
  place.number = number;
  place.lot = (plan.lots_by == LifePlan::LotsBy::level ? level : in_level) % plan.lots;
  place.rig = (in_level / plan.lots) % plan.rigs;
  return place;
}

std::vector<LifeStep> steps_of(const LifePlan& plan, const std::vector<std::size_t>& levels,
                               const std::vector<double>& cycles) {
  std::vector<LifeStep> steps;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LifeLevel& level = plan.levels[levels[i]];
    steps.push_back({level.load, i < cycles.size() ? cycles[i] : level.suspend_at_cycles});
  }
  return steps;
}

class Runner {
 public:
  Runner(const SynthPlan& plan, std::uint64_t seed)
      : plan_(plan),
        seed_(seed),
        model_{*plan.cable, plan.sheath->friction_coefficient, *plan.life} {}

  /// Specimens that all go through the same levels; `group` stands for the level in dealing lots.
  void run(const std::vector<std::size_t>& levels, const std::vector<double>& cycles,
           std::size_t count, bool validation, std::size_t group) {
    const std::vector<LifeStep> steps = steps_of(*plan_.lives, levels, cycles);
    for (std::size_t i = 0; i < count; ++i) {
      LifeSpecimen specimen;
      const std::size_t number = specimens_.size();
      specimen.place = place_of(*plan_.lives, number, i, group);
      specimen.levels = levels;
      specimen.validation = validation;
      specimen.storage_days = plan_.lives->storage_days[number % plan_.lives->storage_days.size()];
      statistics::Random random(seed_, kStrengthStream, number);
      const double strength = std::pow(exponential(random), 1 / plan_.life->weibull_shape);
      specimen.result = run_specimen(model_, steps, strength, specimen.storage_days,
                                     parts_for(plan_, specimen.place, seed_));
      specimens_.push_back(std::move(specimen));
    }
  }

  std::vector<LifeSpecimen> take() { return std::move(specimens_); }

 private:
  const SynthPlan& plan_;
  std::uint64_t seed_;
  LifeModel model_;
  std::vector<LifeSpecimen> specimens_;
};

}  // namespace

std::vector<LifeSpecimen> run_lives(const SynthPlan& plan, std::uint64_t seed) {
  const LifePlan& lives = *plan.lives;
  Runner runner(plan, seed);
  for (std::size_t i = 0; i < lives.levels.size(); ++i) {
    runner.run({i}, {}, lives.levels[i].specimens, lives.levels[i].validation, i);
  }
  for (std::size_t i = 0; i < lives.programs.size(); ++i) {
    const LifeProgram& program = lives.programs[i];
    runner.run(program.levels, program.cycles, program.specimens, program.validation,
               lives.levels.size() + i);
  }
  return runner.take();
}

}  // namespace host_sim::synth
