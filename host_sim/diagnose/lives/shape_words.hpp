#pragma once

#include <cstdint>
#include <string>

#include "host_sim/campaign/campaign.hpp"

namespace host_sim::diagnose::lives {

struct ShapeTestOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// A sentence on the level whose Weibull shape is least like that of the others, by the likelihood
/// ratio of (17) and (18) for one level against the rest; empty where none differs at 5 % for all
/// levels that were looked at.
std::string shape_words(const Campaign& campaign, const ShapeTestOptions& options);

}  // namespace host_sim::diagnose::lives
