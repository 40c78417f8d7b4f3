#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace host_sim::fleet {

/// How many of a fleet break: the probability of each number, from `first` on. What lies outside
/// has less than 1e-20 in all.
struct Demand {
  std::size_t first = 0;
  std::vector<double> probability{1.0};

  [[nodiscard]] double mean() const;
  /// Probability of at most so many.
  [[nodiscard]] double at_most(std::size_t count) const;
  /// The least number that is enough with the probability `service`, 0 .. 1.
  [[nodiscard]] std::size_t quantile(double service) const;
};

/// Of independent breaks with these probabilities: the Poisson-binomial distribution, by
/// convolution of one tendon after the other.
Demand poisson_binomial(std::span<const double> probabilities);

/// Of two fleets that break independently, together.
Demand together(const Demand& one, const Demand& other);

/// Of demands of which one is true, each with its weight.
Demand mixture(std::span<const Demand> demands, std::span<const double> weights);

}  // namespace host_sim::fleet
