#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "host_sim/synth/plan/plan.hpp"
#include "host_sim/synth/specimen.hpp"

namespace host_sim::synth {

/// One specimen of a plan with what became of it.
struct LifeSpecimen {
  SpecimenPlace place;
  std::vector<std::size_t> levels;  ///< places in LifePlan::levels; one, or those of a program
  bool validation = false;
  double storage_days = 0;
  LifeResult result;
};

/// Runs all specimens of a plan: those of the levels in order, then those of the programs.
/// @pre plan.lives
std::vector<LifeSpecimen> run_lives(const SynthPlan& plan, std::uint64_t seed);

/// Of the specimen of this number, from 0.
std::string specimen_name(std::size_t number);

/// Contents of the files; `blocks` is empty where no specimen has a program.
struct LifeTexts {
  std::string specimens, blocks;
};
LifeTexts life_texts(const SynthPlan& plan, std::uint64_t seed);

}  // namespace host_sim::synth
