#pragma once

#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "host_sim/effects/life_effect.hpp"

namespace host_sim::effects {

using Columns = std::vector<std::vector<double>>;

/// All that is known of an effect, as data. The texts and tables must outlive the program.
struct LifeDefinition {
  std::string_view id;
  LifeEffectKind kind = LifeEffectKind::mean;
  std::string_view term;
  std::string_view equation;
  std::string_view life_consequence;
  std::span<const Parameter> parameters;
  std::span<const Separation> separations;
  std::vector<std::vector<double>> shapes = {{}};
  std::string_view (*missing)(const LifeCovariates& covariates) = nullptr;  ///< none: never
  Columns (*columns)(const LifeCovariates& covariates, const LifeBaseline& baseline,
                     std::span<const double> shape) = nullptr;  ///< none: no columns
  Scatter (*scatter)(const LifeCovariates& covariates, const LifeBaseline& baseline,
                     std::span<const double> shape) = nullptr;  ///< none: no scatter
};

/// The catalogue by what the effects depend on; a file each.
std::vector<LifeDefinition> load_effects();
std::vector<LifeDefinition> specimen_effects();

/// One column of an effect that makes ln alpha of each block larger by `change(block, specimen)`.
/// By Miner the damage of a block falls by exp(-change), so that ln N of the specimen grows by
/// -ln(sum of share exp(-change)).
template <typename Change>
std::vector<double> over_blocks(const LifeCovariates& covariates, Change&& change) {
  std::vector<double> column;
  for (std::size_t specimen = 0; specimen < covariates.specimens(); ++specimen) {
    double damage = 0;
    for (const LifeCovariates::Block& block : covariates.blocks[specimen]) {
      damage += block.damage_share * std::exp(-change(block, specimen));
    }
    column.push_back(-std::log(damage));
  }
  return column;
}

}  // namespace host_sim::effects
