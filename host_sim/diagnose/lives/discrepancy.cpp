#include "host_sim/diagnose/lives/discrepancy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/diagnose/lives/looks.hpp"
#include "host_sim/diagnose/lives/nominal.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/bootstrap.hpp"

namespace host_sim::diagnose::lives {
namespace {

constexpr std::uint64_t kOmnibusStream = 501;

std::vector<CoxSnell> residuals_under(const life_law::LifeLaw& law,
                                      const life_law::LifeData& data) {
  std::vector<CoxSnell> residuals;
  residuals.reserve(data.size());
  for (const life_law::LifeDatum& datum : data) {
    double damage = 0;
    for (const life_law::LifeDatum::Block& block : datum.blocks) {
      damage += block.cycles / law.characteristic_life(block.effective_tension_N);
    }
    residuals.push_back({std::pow(damage, law.shape), datum.failed});
  }
  return residuals;
}

/// Statistics of all looks: the observed ones first, then those of each replicate.
using Table = std::vector<std::vector<double>>;

Table simulated(const life_law::LifeData& data, const life_law::LifeFit& fit,
                const std::vector<LookAt>& looks, const OmnibusOptions& options) {
  Table table(options.replicates);
  const life_law::LifeSimulation simulation(data);
  const life_law::LifeLaw law = fit.law();
  const statistics::BootstrapOptions bootstrap{.seed = options.seed,
                                               .stream = kOmnibusStream,
                                               .replicates = options.replicates,
                                               .threads = options.threads};
  statistics::for_each_replicate(bootstrap, [&] {
    return [&, drawn = life_law::LifeData()](statistics::Random& random, std::size_t i) mutable {
      simulation.draw(law, random, drawn);
      const life_law::LifeFit refit = life_law::fit_life(drawn, fit);
      if (refit.problem != statistics::FitProblem::none) {
        return;
      }
      const std::vector<CoxSnell> residuals = residuals_under(refit.law(), drawn);
      for (const LookAt& look : looks) {
        table[i].push_back(look.statistic(residuals));
      }
    };
  });
  std::erase_if(table, [](const std::vector<double>& row) { return row.empty(); });
  return table;
}

/// Share of the rows, the first among them, that are not below the first in this look.
double p_of(const Table& table, std::size_t look) {
  const auto not_below = std::ranges::count_if(
      table, [&](const std::vector<double>& row) { return row[look] >= table.front()[look]; });
  return static_cast<double>(not_below) / static_cast<double>(table.size());
}

/// A look in units of its replicates, cube roots of which are nearly normal (Wilson and Hilferty).
struct Scale {
  double mean = 0, sd = 1;

  [[nodiscard]] double of(double statistic) const { return (std::cbrt(statistic) - mean) / sd; }
};

Scale scale_of(const Table& table, std::size_t look) {
  double sum = 0;
  double squares = 0;
  for (std::size_t row = 1; row < table.size(); ++row) {
    const double root = std::cbrt(table[row][look]);
    sum += root;
    squares += root * root;
  }
  const auto rows = static_cast<double>(std::max<std::size_t>(1, table.size() - 1));
  const double mean = sum / rows;
  const double variance = squares / rows - mean * mean;
  return {mean, variance > 0 ? std::sqrt(variance) : 1};
}

}  // namespace

Omnibus look_at(const LifeSample& sample, const OmnibusOptions& options) {
  const life_law::LifeData data = life_data_of(sample);
  const life_law::LifeFit fit = life_law::fit_life(data);
  Omnibus omnibus;
  if (fit.problem != statistics::FitProblem::none) {
    return omnibus;
  }
  const std::vector<LookAt> looks = looks_of(sample);
  const std::vector<CoxSnell> residuals = residuals_under(fit.law(), data);
  Table table = simulated(data, fit, looks, options);
  std::vector<double> observed;
  observed.reserve(looks.size());
  for (const LookAt& look : looks) {
    observed.push_back(look.statistic(residuals));
  }
  table.insert(table.begin(), observed);
  std::vector<double> largest(table.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < looks.size(); ++k) {
    omnibus.looks.push_back({looks[k].covariate, observed[k], p_of(table, k)});
    const Scale scale = scale_of(table, k);
    for (std::size_t row = 0; row < table.size(); ++row) {
      largest[row] = std::max(largest[row], scale.of(table[row][k]));
    }
  }
  const auto not_below =
      std::ranges::count_if(largest, [&](double value) { return value >= largest.front(); });
  omnibus.p = static_cast<double>(not_below) / static_cast<double>(largest.size());
  return omnibus;
}

LifeSample without_effects(const LifeSample& sample, const std::vector<double>& cox_snell) {
  LifeSample result = sample;
  const NominalFit nominal = fit_nominal(sample);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    LifeSample::Specimen& specimen = result.specimens[i];
    LifeSample::Block block = specimen.last();
    const double ln_life = nominal.ln_life_at_centre -
                           nominal.exponent * (std::log(block.effective_N) - nominal.centre_ln_N);
    block.cycles = std::exp(ln_life + std::log(std::max(cox_snell[i], 1e-12)) / nominal.shape);
    specimen.blocks = {block};
  }
  return result;
}

}  // namespace host_sim::diagnose::lives
