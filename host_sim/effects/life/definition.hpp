#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "host_sim/effects/life_effect.hpp"

namespace host_sim::effects {

using Columns = std::vector<std::vector<double>>;

/// All that the file of an effect says, as data. The texts and tables must outlive the program.
struct LifeDefinition {
  std::string_view id;
  LifeEffect::Kind kind = LifeEffect::Kind::mean;
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

std::unique_ptr<LifeEffect> effect_of(LifeDefinition definition);

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
