#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"

namespace host_sim::effects {

/// The nominal life that effects change: alpha = A / T_eff^gamma (19), T_eff by Gerber (11).
struct LifeBaseline {
  double ultimate_tension_N = 0;  ///< T_u
  double ipl_scale = 0;           ///< A
  double ipl_exponent = 0;        ///< gamma
};

/// What effects on life are written in terms of. Each vector has one value for each specimen, or is
/// empty where one of them lacks it.
struct LifeCovariates {
  struct Block {
    double mean_N = 0;       ///< T_m of input tension
    double amplitude_N = 0;  ///< T_a
    double effective_N = 0;  ///< T_eff
    double cycles = 0;
    double life_cycles = 0;   ///< alpha
    double damage_share = 0;  ///< of the specimen's damage by Miner; all sum to 1
  };
  std::vector<std::vector<Block>> blocks;  ///< in order of loading; at least one a specimen
  std::vector<double> log_effective_N;     ///< ln of the constant T_eff of the same damage
  std::vector<std::size_t> level;  ///< by rising T_eff, from 0; specimens of one load share it
  std::vector<std::size_t> lot;    ///< in order of the lots' names, from 0
  std::vector<std::string> group;
  std::vector<double> days;
  std::vector<double> wire_to_bend_ratio;

  [[nodiscard]] std::size_t specimens() const { return blocks.size(); }
  [[nodiscard]] std::size_t levels() const;
  [[nodiscard]] std::size_t lots() const;
  [[nodiscard]] double lowest_effective_N() const;  ///< of all blocks
};

/// @pre T_eff above 0 in each block, as read_campaign() makes sure
LifeCovariates life_covariates_of(std::span<const Campaign::Specimen> specimens,
                                  const LifeBaseline& baseline);

}  // namespace host_sim::effects
