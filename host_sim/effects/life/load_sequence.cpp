#include <algorithm>

#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

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

}  // namespace

std::unique_ptr<LifeEffect> make_load_sequence();

std::unique_ptr<LifeEffect> make_load_sequence() {
  return effect_of(
      {.id = "load_sequence",
       .term = "nonlinear damage accumulation (Manson and Halford)",
       .equation = "(n1/N1)^((N1/N2)^q) + n2/N2 = 1, q about 0.4",
       .life_consequence =
           "a high load first leaves less life than Miner says, a low load first leaves more",
       .parameters = kParameters,
       .separations = kSeparations,
       .shapes = {{0.1}, {0.2}, {0.3}, {0.4}, {0.5}, {0.6}, {0.8}},
       .missing = missing,
       .columns = columns});
}

}  // namespace host_sim::effects
