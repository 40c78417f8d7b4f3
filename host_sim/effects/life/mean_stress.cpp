#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "mean_stress_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "walker_exponent", .unit = "1", .minimum = 0, .maximum = 0.8, .typical = 0.5},
};

constexpr Separation kSeparations[] = {
    {"bending_fatigue", "vary the mean at a fixed amplitude"},
    {"endurance_limit", "vary the mean at a fixed amplitude"},
};

double effective_N(const LifeCovariates::Block& block, double walker, double ultimate_N) {
  if (walker > 0) {
    return std::pow(block.mean_N + block.amplitude_N, 1 - walker) *
           std::pow(block.amplitude_N, walker);
  }
  return block.amplitude_N / (1 - block.mean_N / ultimate_N);
}

/// ln alpha = ln A - gamma ln T_eff, so it changes by -gamma ln(T_eff of the law/T_eff of Gerber).
Columns columns(const LifeCovariates& covariates, const LifeBaseline& baseline,
                std::span<const double> shape) {
  const double walker = shape[0];
  return {over_blocks(covariates, [&](const LifeCovariates::Block& block, std::size_t) {
    const double law_N = effective_N(block, walker, baseline.ultimate_tension_N);
    return -baseline.ipl_exponent * std::log(law_N / block.effective_N);
  })};
}

}  // namespace

std::unique_ptr<LifeEffect> make_mean_stress();

std::unique_ptr<LifeEffect> make_mean_stress() {
  return effect_of(
      {.id = "mean_stress",
       .term = "mean-stress law: Walker, Smith-Watson-Topper or Goodman in place of Gerber",
       .equation = "T_eff = (T_m + T_a)^(1-w) T_a^w (Walker; w = 1/2 is Smith-Watson-Topper), or "
                   "T_a/(1 - T_m/T_u) where w = 0 (Goodman)",
       .life_consequence = "lives at another mean than the tested one are wrong by (T_eff of "
                           "Gerber over the true one)^gamma",
       .parameters = kParameters,
       .separations = kSeparations,
       .shapes = {{0}, {0.4}, {0.5}, {0.6}, {0.7}, {0.8}},
       .columns = columns});
}

}  // namespace host_sim::effects
