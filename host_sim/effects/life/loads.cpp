#include <algorithm>

#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

namespace bending_fatigue {

constexpr Parameter kParameters[] = {
    {.name = "bending_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "bending_N", .unit = "N", .minimum = 50, .maximum = 2000, .typical = 400},
};

constexpr Separation kSeparations[] = {
    {"mean_stress", "test two bend diameters at one tension"},
    {"second_mode", "test two bend diameters at one tension"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.wire_to_bend_ratio.empty()
             ? "no wire-to-bend ratio of each specimen (wire_to_bend_ratio)"
             : "";
}

/// With Gerber T_eff grows by the factor 1 + c (d_w/D)/T_a.
Columns columns(const LifeCovariates& covariates, const LifeBaseline& baseline,
                std::span<const double> shape) {
  const double bending_N = shape[0];
  return {over_blocks(covariates, [&](const LifeCovariates::Block& block, std::size_t specimen) {
    const double amplitude_N = bending_N * covariates.wire_to_bend_ratio[specimen];
    return -baseline.ipl_exponent * std::log1p(amplitude_N / block.amplitude_N);
  })};
}

LifeDefinition definition() {
  return {.id = "bending_fatigue",
          .term = "bending stress of the wire over a small radius",
          .equation = "T_a + c d_w/D in place of T_a, d_w/D the ratio of wire to bend",
          .life_consequence =
              "tight bends cost life that no tension shows: at a given "
              "tension it falls with the ratio of wire to bend",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{50}, {100}, {200}, {400}, {800}, {2000}},
          .missing = missing,
          .columns = columns};
}

}  // namespace bending_fatigue

namespace endurance_limit {

constexpr Parameter kParameters[] = {
    {.name = "endurance_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "limit_log_sd", .unit = "1", .minimum = 0, .maximum = 0.5, .typical = 0.1},
    {.name = "limit_of_lowest", .unit = "1", .minimum = 0.1, .maximum = 1.5, .typical = 0.7},
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

LifeDefinition definition() {
  return {.id = "endurance_limit",
          .kind = LifeEffectKind::both,
          .term = "fatigue limit, curvature of the S-N line",
          .equation =
              "alpha = A/(T_eff - S_e)^gamma, S_e of each specimen lognormal about a share of the "
              "lowest level (random fatigue limit of Pascual and Meeker)",
          .life_consequence =
              "light use lasts longer than the straight line says, without end below "
              "the limit, and scatters the more the nearer it is",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{0.1}, {0.2}, {0.3}, {0.4}, {0.5}, {0.6}, {0.7}, {0.8}, {0.85}, {0.9}, {0.95}},
          .missing = missing,
          .columns = columns,
          .scatter = scatter};
}

}  // namespace endurance_limit

namespace load_sequence {

constexpr Parameter kParameters[] = {
    {.name = "sequence_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "sequence_exponent", .unit = "1", .minimum = 0.1, .maximum = 0.8, .typical = 0.4},
};

constexpr Separation kSeparations[] = {
    {"lot_frailty", "load blocks from high to low AND from low to high, in each lot"},
};

std::string_view missing(const LifeCovariates& covariates) {
  for (const std::vector<LifeCovariates::Block>& blocks : covariates.blocks) {
    if (blocks.size() > 1) {
      return "";
    }
  }
  return "no specimen loaded in blocks (blocks.csv)";
}

/// Damage by Miner of a specimen that fails when the damage x of Manson and Halford, carried from
/// block to block as x^((N_before/N)^q), reaches 1. The last block runs on until then.
double miner_at_failure(const std::vector<LifeCovariates::Block>& blocks, double exponent) {
  double miner = 0;
  double damage = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (i > 0) {
      const double ratio = blocks[i - 1].life_cycles / blocks[i].life_cycles;
      damage = std::pow(damage, std::pow(ratio, exponent));
    }
    const double share = std::min(blocks[i].cycles / blocks[i].life_cycles, 1 - damage);
    const double used = i + 1 == blocks.size() ? 1 - damage : share;
    miner += used;
    damage += used;
  }
  return miner;
}

/// By Miner alone it would be 1.
Columns columns(const LifeCovariates& covariates, const LifeBaseline&,
                std::span<const double> shape) {
  std::vector<double> column;
  for (const std::vector<LifeCovariates::Block>& blocks : covariates.blocks) {
    column.push_back(std::log(miner_at_failure(blocks, shape[0])));
  }
  return {column};
}

LifeDefinition definition() {
  return {.id = "load_sequence",
          .term = "nonlinear damage accumulation (Manson and Halford)",
          .equation = "(n1/N1)^((N1/N2)^q) + n2/N2 = 1, q about 0.4",
          .life_consequence =
              "a high load first leaves less life than Miner says, a low load first leaves more",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{0.1}, {0.2}, {0.3}, {0.4}, {0.5}, {0.6}, {0.8}},
          .missing = missing,
          .columns = columns};
}

}  // namespace load_sequence

namespace mean_stress {

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

LifeDefinition definition() {
  return {.id = "mean_stress",
          .term = "mean-stress law: Walker, Smith-Watson-Topper or Goodman in place of Gerber",
          .equation =
              "T_eff = (T_m + T_a)^(1-w) T_a^w (Walker; w = 1/2 is Smith-Watson-Topper), or "
              "T_a/(1 - T_m/T_u) where w = 0 (Goodman)",
          .life_consequence =
              "lives at another mean than the tested one are wrong by (T_eff of "
              "Gerber over the true one)^gamma",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{0}, {0.4}, {0.5}, {0.6}, {0.7}, {0.8}},
          .columns = columns};
}

}  // namespace mean_stress

}  // namespace

std::vector<LifeDefinition> load_effects() {
  return {bending_fatigue::definition(), endurance_limit::definition(), load_sequence::definition(),
          mean_stress::definition()};
}

}  // namespace host_sim::effects
