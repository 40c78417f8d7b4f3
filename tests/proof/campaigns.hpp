#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "host_sim/plan/design.hpp"

namespace host_sim::proof {

/// The law of the paper's section 3.5.
inline const life_law::LifeLaw kTruth{.scale = 1.53e5, .exponent = 1.38, .shape = 5.94};

/// The paper's effective tension for the glove of its section 3.3, far below all levels.
inline constexpr double kUseTension_N = 25.5;

/// Four levels of 20 as in the paper.
plan::Design whole_design();

/// The same with every specimen suspended that outlasts the median life of the lowest level: half
/// of that level, and about one in 25 of the next.
plan::Design suspended_design();

/// `wanted` campaigns in a release build, fewer where each takes long.
std::size_t campaigns(std::size_t wanted);

/// How many of some campaigns something holds for.
struct Share {
  std::size_t holds = 0;
  std::size_t campaigns = 0;

  [[nodiscard]] double value() const;
  /// `sigmas` binomial errors for a true share of `expected`.
  [[nodiscard]] double tolerance(double expected, double sigmas) const;
};

/// Prints `proof: what: share of campaigns`.
void report(const std::string& what, const Share& share);

/// Expects p-values that are each one of 1 / (replicates + 1), 2 / (replicates + 1) .. 1 to be
/// uniform: the largest distance of their distribution from the diagonal is below what one sample
/// in a thousand exceeds (1.95 / sqrt(n), Kolmogorov) and a step of theirs, and at most 5 % within
/// 3 binomial errors are at or below 0.05. Prints both figures.
void expect_uniform(const std::string& what, std::vector<double> p, std::size_t replicates);

}  // namespace host_sim::proof
