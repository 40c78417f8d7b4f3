#include "host_sim/fleet/demand.hpp"

#include <algorithm>
#include <limits>

namespace host_sim::fleet {
namespace {

/// What is cut off at an end at a time: a hundred thousand tendons cut off below 1e-22 in all.
constexpr double kNegligible = 1e-28;

void trim(Demand& demand) {
  std::vector<double>& p = demand.probability;
  while (p.size() > 1 && p.back() < kNegligible) {
    p.pop_back();
  }
  const auto begin =
      std::find_if(p.begin(), p.end() - 1, [](double value) { return value >= kNegligible; });
  demand.first += static_cast<std::size_t>(begin - p.begin());
  p.erase(p.begin(), begin);
}

}  // namespace

double Demand::mean() const {
  double sum = 0;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    sum += static_cast<double>(first + i) * probability[i];
  }
  return sum;
}

double Demand::at_most(std::size_t count) const {
  double sum = 0;
  for (std::size_t i = 0; i < probability.size() && first + i <= count; ++i) {
    sum += probability[i];
  }
  return std::min(sum, 1.0);
}

std::size_t Demand::quantile(double service) const {
  // Sums of probabilities are known to their rounding.
  const double wanted = service - 16 * std::numeric_limits<double>::epsilon();
  double sum = 0;
  for (std::size_t i = 0; i + 1 < probability.size(); ++i) {
    sum += probability[i];
    if (sum >= wanted) {
      return first + i;
    }
  }
  return first + probability.size() - 1;
}

Demand poisson_binomial(std::span<const double> probabilities) {
  constexpr std::size_t kTrimEach = 16;
  Demand demand;
  std::vector<double> next;
  std::size_t done = 0;
  for (const double p : probabilities) {
    const std::vector<double>& now = demand.probability;
    const double q = 1 - p;
    next.resize(now.size() + 1);
    next.front() = q * now.front();
    for (std::size_t i = 1; i < now.size(); ++i) {
      next[i] = q * now[i] + p * now[i - 1];
    }
    next.back() = p * now.back();
    demand.probability.swap(next);
    if (++done % kTrimEach == 0) {
      trim(demand);
    }
  }
  trim(demand);
  return demand;
}

Demand together(const Demand& one, const Demand& other) {
  Demand sum;
  sum.first = one.first + other.first;
  sum.probability.assign(one.probability.size() + other.probability.size() - 1, 0);
  for (std::size_t i = 0; i < one.probability.size(); ++i) {
    for (std::size_t j = 0; j < other.probability.size(); ++j) {
      sum.probability[i + j] += one.probability[i] * other.probability[j];
    }
  }
  trim(sum);
  return sum;
}

Demand mixture(std::span<const Demand> demands, std::span<const double> weights) {
  std::size_t first = std::numeric_limits<std::size_t>::max();
  std::size_t end = 0;
  for (const Demand& demand : demands) {
    first = std::min(first, demand.first);
    end = std::max(end, demand.first + demand.probability.size());
  }
  Demand mixed;
  mixed.first = first;
  mixed.probability.assign(end - first, 0);
  for (std::size_t k = 0; k < demands.size(); ++k) {
    for (std::size_t i = 0; i < demands[k].probability.size(); ++i) {
      mixed.probability[demands[k].first - first + i] += weights[k] * demands[k].probability[i];
    }
  }
  trim(mixed);
  return mixed;
}

}  // namespace host_sim::fleet
