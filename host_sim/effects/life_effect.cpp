#include "host_sim/effects/life_effect.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host_sim/reference/equations.hpp"

namespace host_sim::effects {
namespace {

using Block = LifeCovariates::Block;

/// The same load written in two ways, as through bend angle and output tension, differs by
/// rounding.
constexpr double kSameLevel = 1e-9;

std::vector<Block> blocks_of(const Campaign::Specimen& specimen, const LifeBaseline& baseline) {
  std::vector<Block> blocks;
  double damage = 0;
  for (const Campaign::Block& loaded : specimen.blocks) {
    const double life_cycles = reference::ipl_life_cycles(
        loaded.load.effective_tension_N, baseline.ipl_scale, baseline.ipl_exponent);
    blocks.push_back({.mean_N = loaded.load.input_tension_mean_N,
                      .amplitude_N = loaded.load.input_tension_amplitude_N,
                      .effective_N = loaded.load.effective_tension_N,
                      .cycles = loaded.cycles,
                      .life_cycles = life_cycles,
                      .damage_share = loaded.cycles / life_cycles});
    damage += blocks.back().damage_share;
  }
  for (Block& block : blocks) {
    block.damage_share /= damage;
  }
  return blocks;
}

/// Equal damage in equal cycles: the power mean of order gamma.
double log_equivalent(const std::vector<Block>& blocks, double ipl_exponent) {
  double cycles = 0;
  double powers = 0;
  for (const Block& block : blocks) {
    cycles += block.cycles;
    powers += block.cycles * std::pow(block.effective_N, ipl_exponent);
  }
  return std::log(powers / cycles) / ipl_exponent;
}

template <typename Value>
std::size_t place_of(const std::vector<Value>& sorted, const Value& value) {
  return static_cast<std::size_t>(std::ranges::lower_bound(sorted, value) - sorted.begin());
}

std::vector<std::size_t> levels_by(const std::vector<double>& log_effective_N) {
  std::vector<double> sorted = log_effective_N;
  std::ranges::sort(sorted);
  std::vector<double> firsts;
  for (const double value : sorted) {
    if (firsts.empty() || value - firsts.back() > kSameLevel) {
      firsts.push_back(value);
    }
  }
  std::vector<std::size_t> levels;
  for (const double value : log_effective_N) {
    const auto after = std::ranges::upper_bound(firsts, value);
    levels.push_back(static_cast<std::size_t>(after - firsts.begin()) - 1);
  }
  return levels;
}

std::vector<std::size_t> lots_of(std::span<const Campaign::Specimen> specimens) {
  std::vector<std::string> names;
  std::ranges::transform(specimens, std::back_inserter(names), &Campaign::Specimen::lot);
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::vector<std::size_t> lots;
  for (const Campaign::Specimen& specimen : specimens) {
    lots.push_back(place_of(names, specimen.lot));
  }
  return lots;
}

std::vector<double> all_or_none(std::span<const Campaign::Specimen> specimens,
                                std::optional<double> Campaign::Specimen::*value) {
  std::vector<double> values;
  for (const Campaign::Specimen& specimen : specimens) {
    const std::optional<double>& given = specimen.*value;
    if (!given) {
      return {};
    }
    values.push_back(*given);
  }
  return values;
}

std::size_t count_of(const std::vector<std::size_t>& indices) {
  return indices.empty() ? 0 : std::ranges::max(indices) + 1;
}

}  // namespace

std::size_t LifeCovariates::levels() const {
  return count_of(level);
}

std::size_t LifeCovariates::lots() const {
  return count_of(lot);
}

double LifeCovariates::lowest_effective_N() const {
  double lowest_N = blocks.empty() ? 0 : blocks.front().front().effective_N;
  for (const std::vector<Block>& loaded : blocks) {
    for (const Block& block : loaded) {
      lowest_N = std::min(lowest_N, block.effective_N);
    }
  }
  return lowest_N;
}

LifeCovariates life_covariates_of(std::span<const Campaign::Specimen> specimens,
                                  const LifeBaseline& baseline) {
  LifeCovariates covariates;
  for (const Campaign::Specimen& specimen : specimens) {
    covariates.blocks.push_back(blocks_of(specimen, baseline));
    covariates.log_effective_N.push_back(
        log_equivalent(covariates.blocks.back(), baseline.ipl_exponent));
    covariates.group.push_back(specimen.group);
  }
  covariates.level = levels_by(covariates.log_effective_N);
  covariates.lot = lots_of(specimens);
  covariates.days = all_or_none(specimens, &Campaign::Specimen::days);
  covariates.wire_to_bend_ratio = all_or_none(specimens, &Campaign::Specimen::wire_to_bend_ratio);
  return covariates;
}

}  // namespace host_sim::effects
