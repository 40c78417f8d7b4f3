#include "host_sim/diagnose/lives/looks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace host_sim::diagnose::lives {
namespace {

using Residuals = std::span<const CoxSnell>;
using Numbers = std::vector<std::size_t>;

/// Score of ln alpha of each group, squared, over its size.
LookAt between(std::string covariate, Numbers group, std::size_t groups) {
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
LookAt shapes_between(Numbers level, std::size_t levels) {
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

LookAt along(std::string covariate, std::vector<double> values) {
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

void add_values(const LifeSample& sample, std::vector<LookAt>& looks) {
  const auto add = [&](std::string covariate, std::vector<double> values) {
    if (varies(values)) {
      looks.push_back(along(std::move(covariate), std::move(values)));
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

}  // namespace

std::vector<LookAt> looks_of(const LifeSample& sample) {
  std::vector<LookAt> looks;
  add_values(sample, looks);
  looks.push_back(between(
      "load", numbers(sample, [](const auto& specimen) { return specimen.load; }), sample.loads));
  looks.push_back(shapes_between(
      numbers(sample, [](const auto& specimen) { return specimen.last().level; }), sample.levels));
  if (sample.lots > 1) {
    looks.push_back(
        between("lot", numbers(sample, [](const auto& specimen) { return specimen.lot_number; }),
                sample.lots));
  }
  if (sample.groups > 1) {
    looks.push_back(between("group",
                            numbers(sample, [](const auto& specimen) { return specimen.group; }),
                            sample.groups));
  }
  const Numbers orders = numbers(sample, order_of);
  if (std::ranges::any_of(orders, [](std::size_t order) { return order < 2; })) {
    looks.push_back(between("block_order", orders, 2));
  }
  looks.push_back({"early_failures", early});
  looks.push_back({"late_failures", late});
  return looks;
}

}  // namespace host_sim::diagnose::lives
