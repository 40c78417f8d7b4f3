#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "host_sim/plan/simulated_campaign.hpp"

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
void tell(const std::string& what, const Share& share);

}  // namespace host_sim::proof
