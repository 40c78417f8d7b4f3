#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "endurance_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "limit_log_sd", .unit = "1", .minimum = 0, .maximum = 0.5, .typical = 0.1},
    {.name = "limit_of_lowest", .unit = "1", .minimum = 0.1, .maximum = 0.95, .typical = 0.6},
};

constexpr Separation kSeparations[] = {
    {"second_mode", "add a low level with suspended specimens"},
    {"small_cycles", "sweep the hysteresis of the count: an endurance limit does not move with it"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.levels() < 3 ? "three levels or more: two give one slope and no curvature" : "";
}

double limit_share(const LifeCovariates& covariates, const LifeCovariates::Block& block,
                   std::span<const double> shape) {
  return shape[0] * covariates.lowest_effective_N() / block.effective_N;
}

/// ln alpha = ln A - gamma ln(T_eff - S_e), so it changes by -gamma ln(1 - S_e/T_eff).
Columns columns(const LifeCovariates& covariates, const LifeBaseline& baseline,
                std::span<const double> shape) {
  return {over_blocks(covariates, [&](const LifeCovariates::Block& block, std::size_t) {
    return -baseline.ipl_exponent * std::log1p(-limit_share(covariates, block, shape));
  })};
}

/// d ln alpha/d ln S_e = gamma S_e/(T_eff - S_e), of each block by its share of the damage.
Scatter scatter(const LifeCovariates& covariates, const LifeBaseline& baseline,
                std::span<const double> shape) {
  Scatter scatter;
  for (std::size_t specimen = 0; specimen < covariates.specimens(); ++specimen) {
    double slope = 0;
    for (const LifeCovariates::Block& block : covariates.blocks[specimen]) {
      const double share = limit_share(covariates, block, shape);
      slope += block.damage_share * baseline.ipl_exponent * share / (1 - share);
    }
    scatter.log_life_sd.push_back(slope);
    scatter.shared_by.push_back(specimen);
  }
  return scatter;
}

}  // namespace

std::unique_ptr<LifeEffect> make_endurance_limit();

std::unique_ptr<LifeEffect> make_endurance_limit() {
  return effect_of(
      {.id = "endurance_limit",
       .kind = LifeEffect::Kind::both,
       .term = "fatigue limit, curvature of the S-N line",
       .equation = "alpha = A/(T_eff - S_e)^gamma, S_e a share of the lowest level, its logarithm "
                   "with scatter (Pascual and Meeker)",
       .life_consequence = "light use lasts longer than the straight line says, without end below "
                           "the limit, and scatters the more the nearer it is",
       .parameters = kParameters,
       .separations = kSeparations,
       .shapes = {{0.1}, {0.2}, {0.3}, {0.4}, {0.5}, {0.6}, {0.7}, {0.8}, {0.85}, {0.9}, {0.95}},
       .missing = missing,
       .columns = columns,
       .scatter = scatter});
}

}  // namespace host_sim::effects
