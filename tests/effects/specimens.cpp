#include "tests/effects/specimens.hpp"

#include <stdexcept>

namespace host_sim::effects::testing {

Campaign::Load load(double mean_N, double amplitude_N) {
  const double ratio = mean_N / kLife.ultimate_tension_N;
  return {.bend_angle_deg = {},
          .input_tension_mean_N = mean_N,
          .input_tension_amplitude_N = amplitude_N,
          .effective_tension_N = amplitude_N / (1 - ratio * ratio)};
}

Campaign::Specimen specimen(const std::string& name, double effective_N, double cycles) {
  return in_blocks(name, {{effective_N, cycles}});
}

Campaign::Specimen in_blocks(const std::string& name, const std::vector<BlockOf>& blocks) {
  Campaign::Specimen made;
  made.name = name;
  made.lot = "one";
  for (const BlockOf& block : blocks) {
    made.blocks.push_back({.load = load(0, block.effective_N), .cycles = block.cycles});
  }
  return made;
}

const LifeEffect& life_effect(std::string_view id) {
  for (const auto& effect : life_effects()) {
    if (effect->id() == id) {
      return *effect;
    }
  }
  throw std::out_of_range(std::string(id));
}

std::vector<std::vector<double>> life_columns(std::string_view id,
                                              const std::vector<Campaign::Specimen>& specimens,
                                              const std::vector<double>& shape) {
  return life_effect(id).signature(life_covariates_of(specimens, kLife), kLife, shape).columns;
}

Scatter life_scatter(std::string_view id, const std::vector<Campaign::Specimen>& specimens,
                     const std::vector<double>& shape) {
  return life_effect(id).scatter(life_covariates_of(specimens, kLife), kLife, shape);
}

}  // namespace host_sim::effects::testing
