#pragma once

#include <string>
#include <vector>

#include "host_sim/effects/life_effect.hpp"

namespace host_sim::effects::testing {

/// T_u of the paper's wire; life 1000 cycles at 10 N and a quarter of that at 20 N.
inline constexpr LifeBaseline kLife{
    .ultimate_tension_N = 177.4, .ipl_scale = 1e5, .ipl_exponent = 2};

/// A load as Gerber (11) makes it.
Campaign::Load load(double mean_N, double amplitude_N);

/// One load without mean, so that T_eff is the amplitude.
Campaign::Specimen specimen(const std::string& name, double effective_N, double cycles = 100);

struct BlockOf {
  double effective_N;
  double cycles;
};
Campaign::Specimen in_blocks(const std::string& name, const std::vector<BlockOf>& blocks);

/// The effect of this id. @throws std::out_of_range
const LifeEffect& life_effect(std::string_view id);

std::vector<std::vector<double>> life_columns(std::string_view id,
                                              const std::vector<Campaign::Specimen>& specimens,
                                              const std::vector<double>& shape = {});
Scatter life_scatter(std::string_view id, const std::vector<Campaign::Specimen>& specimens,
                     const std::vector<double>& shape = {});

}  // namespace host_sim::effects::testing
