#pragma once

#include <cstdint>
#include <string>

#include "host_sim/campaign/campaign.hpp"

namespace host_sim::test {

/// What is hidden in the lives of a simulated campaign.
struct Scenario {
  std::size_t specimens = 96;
  /// Ids of synth, two joined by "+", or "none".
  std::string hidden = "none";
  std::uint64_t seed = 1;  ///< of the sizes and of the lives
};

/// A campaign with levels crossed with lots, rigs, mean tensions, bend ratios and storage, with
/// blocks from high to low and from low to high. Sizes come out of the ranges of the catalogue.
Campaign simulated(const Scenario& scenario);

/// A campaign by the text of a plan for host_sim synth.
Campaign simulated(const std::string& plan_text, std::uint64_t seed);

/// The plan of it, for host_sim synth.
std::string plan_text(const Scenario& scenario);

}  // namespace host_sim::test
