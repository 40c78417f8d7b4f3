#include "host_sim/diagnose/lives/discrepancy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host_sim/diagnose/lives/fit.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/bootstrap.hpp"

namespace host_sim::diagnose::lives {
namespace {

using Residuals = std::span<const CoxSnell>;
using Numbers = std::vector<std::size_t>;

/// Score of ln alpha of each group, squared, over its size.
CovariateStatistic between(std::string covariate, Numbers group, std::size_t groups) {
  return {std::move(covariate), [group = std::move(group), groups](Residuals residuals) {
            std::vector<double> sums(groups);
            std::vector<double> counts(groups);
            for (std::size_t i = 0; i < residuals.size(); ++i) {
              if (group[i] < groups) {
                sums[group[i]] += residuals[i].excess();
                counts[group[i]] += 1;
              }
            }
            double statistic = 0;
            for (std::size_t g = 0; g < groups; ++g) {
              statistic += counts[g] > 0 ? sums[g] * sums[g] / counts[g] : 0;
            }
            return statistic;
          }};
}

/// Score of ln beta: d (1 + ln e) - e ln e.
CovariateStatistic shapes_between(Numbers level, std::size_t levels) {
  return {"shape", [level = std::move(level), levels](Residuals residuals) {
            std::vector<double> sums(levels);
            std::vector<double> counts(levels);
            for (std::size_t i = 0; i < residuals.size(); ++i) {
              const double e = std::max(residuals[i].value, 1e-12);
              sums[level[i]] += (residuals[i].failed ? 1 : 0) + residuals[i].excess() * std::log(e);
              counts[level[i]] += 1;
            }
            double statistic = 0;
            for (std::size_t l = 0; l < levels; ++l) {
              statistic += counts[l] > 0 ? sums[l] * sums[l] / counts[l] : 0;
            }
            return statistic;
          }};
}

CovariateStatistic along(std::string covariate, std::vector<double> values) {
  double mean = 0;
  for (const double value : values) {
    mean += value / static_cast<double>(values.size());
  }
  for (double& value : values) {
    value -= mean;
  }
  return {std::move(covariate), [values = std::move(values)](Residuals residuals) {
            double sum = 0;
            for (std::size_t i = 0; i < residuals.size(); ++i) {
              sum += values[i] * residuals[i].excess();
            }
            return std::abs(sum);
          }};
}

/// Fisher's sum of -ln of the probability to have failed so soon: failures that come early.
double early(Residuals residuals) {
  double sum = 0;
  for (const CoxSnell& residual : residuals) {
    if (residual.failed) {
      sum -= std::log(-std::expm1(-std::max(residual.value, 1e-300)));
    }
  }
  return sum;
}

double late(Residuals residuals) {
  double sum = 0;
  for (const CoxSnell& residual : residuals) {
    sum += residual.value * residual.value;
  }
  return sum;
}

/// Of Anderson and Darling, from the exponential distribution.
double distance(Residuals residuals) {
  statistics::Sample lives;
  for (const CoxSnell& residual : residuals) {
    lives.push_back({std::max(residual.value, 1e-300), residual.failed});
  }
  return statistics::anderson_darling({statistics::Family::weibull, 1, 1}, lives);
}

template <typename Value>
std::vector<double> each(const LifeSample& sample, Value value) {
  std::vector<double> values;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    values.push_back(value(specimen));
  }
  return values;
}

template <typename Number>
Numbers numbers(const LifeSample& sample, Number number) {
  Numbers all;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    all.push_back(number(specimen));
  }
  return all;
}

bool varies(const std::vector<double>& values) {
  return std::ranges::max(values) - std::ranges::min(values) >
         1e-9 * (1 + std::abs(values.front()));
}

/// 0 where the load falls, 1 where it rises, 2 where it is constant.
std::size_t order_of(const LifeSample::Specimen& specimen) {
  if (specimen.order == LifeSample::Order::constant) {
    return 2;
  }
  return specimen.order == LifeSample::Order::falling ? 0 : 1;
}

void add_values(const LifeSample& sample, std::vector<CovariateStatistic>& statistics) {
  const auto add = [&](std::string covariate, std::vector<double> values) {
    if (varies(values)) {
      statistics.push_back(along(std::move(covariate), std::move(values)));
    }
  };
  const double middle = std::sqrt(sample.lowest_N * sample.highest_N);
  add("curvature", each(sample, [middle](const auto& specimen) {
        const double x = std::log(specimen.last().effective_N / middle);
        return x * x;
      }));
  add("mean_tension_share", each(sample, [](const auto& specimen) {
        const auto& block = specimen.last();
        return block.mean_N / (block.mean_N + block.amplitude_N);
      }));
  if (sample.has_days) {
    add("days", each(sample, [](const auto& specimen) { return specimen.days; }));
  }
  if (sample.has_ratios) {
    add("wire_to_bend_ratio",
        each(sample, [](const auto& specimen) { return specimen.last().wire_to_bend_ratio; }));
  }
}

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

/// All statistics: the observed ones first, then those of each replicate.
using Table = std::vector<std::vector<double>>;

Table simulated(const life_law::LifeData& data, const LawOfSample& of_sample,
                const life_law::LifeFit& fit, const std::vector<CovariateStatistic>& statistics,
                const OmnibusOptions& options) {
  Table table(options.replicates);
  const life_law::LifeSimulation simulation(data);
  const life_law::LifeLaw law = of_sample.law(fit);
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
      const std::vector<CoxSnell> residuals = residuals_under(of_sample.law(refit), drawn);
      for (const CovariateStatistic& test : statistics) {
        table[i].push_back(test.statistic(residuals));
      }
    };
  });
  std::erase_if(table, [](const std::vector<double>& row) { return row.empty(); });
  return table;
}

/// Share of the rows, the first among them, that are not below the first in this test.
double p_of(const Table& table, std::size_t test) {
  const auto not_below = std::ranges::count_if(
      table, [&](const std::vector<double>& row) { return row[test] >= table.front()[test]; });
  return static_cast<double>(not_below) / static_cast<double>(table.size());
}

/// A statistic in units of its replicates, cube roots of which are nearly normal (Wilson and
/// Hilferty).
struct Scale {
  double mean = 0, sd = 1;

  [[nodiscard]] double of(double statistic) const { return (std::cbrt(statistic) - mean) / sd; }
};

Scale scale_of(const Table& table, std::size_t test) {
  double sum = 0;
  double squares = 0;
  for (std::size_t row = 1; row < table.size(); ++row) {
    const double root = std::cbrt(table[row][test]);
    sum += root;
    squares += root * root;
  }
  const auto rows = static_cast<double>(std::max<std::size_t>(1, table.size() - 1));
  const double mean = sum / rows;
  const double variance = squares / rows - mean * mean;
  return {mean, variance > 0 ? std::sqrt(variance) : 1};
}

}  // namespace

std::vector<CovariateStatistic> covariate_statistics(const LifeSample& sample) {
  std::vector<CovariateStatistic> statistics;
  add_values(sample, statistics);
  if (sample.loads > 1) {
    statistics.push_back(between(
        "load", numbers(sample, [](const auto& specimen) { return specimen.load; }), sample.loads));
  }
  if (sample.levels > 1) {
    statistics.push_back(
        shapes_between(numbers(sample, [](const auto& specimen) { return specimen.last().level; }),
                       sample.levels));
  } else {
    statistics.push_back({"distribution", distance});
  }
  if (sample.lots > 1) {
    statistics.push_back(
        between("lot", numbers(sample, [](const auto& specimen) { return specimen.lot_number; }),
                sample.lots));
  }
  if (sample.groups > 1) {
    statistics.push_back(
        between("group", numbers(sample, [](const auto& specimen) { return specimen.group; }),
                sample.groups));
  }
  const Numbers orders = numbers(sample, order_of);
  if (std::ranges::any_of(orders, [](std::size_t order) { return order < 2; })) {
    statistics.push_back(between("block_order", orders, 2));
  }
  statistics.push_back({"early_failures", early});
  statistics.push_back({"late_failures", late});
  return statistics;
}

Omnibus omnibus_test(const LifeSample& sample, const OmnibusOptions& options) {
  const life_law::LifeData data = life_data_of(sample);
  const LawOfSample of_sample(sample);
  const life_law::LifeFit fit = of_sample.fit(data);
  Omnibus omnibus;
  if (fit.problem != statistics::FitProblem::none) {
    return omnibus;
  }
  const std::vector<CovariateStatistic> statistics = covariate_statistics(sample);
  const std::vector<CoxSnell> residuals = residuals_under(of_sample.law(fit), data);
  Table table = simulated(data, of_sample, fit, statistics, options);
  std::vector<double> observed;
  observed.reserve(statistics.size());
  for (const CovariateStatistic& test : statistics) {
    observed.push_back(test.statistic(residuals));
  }
  table.insert(table.begin(), observed);
  std::vector<double> largest(table.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < statistics.size(); ++k) {
    omnibus.tests.push_back({statistics[k].covariate, observed[k], p_of(table, k)});
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
