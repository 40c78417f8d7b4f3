#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::statistics {

/// `count` failures out of a distribution.
Sample drawn_from(const Distribution& distribution, std::size_t count, Random& random);
Sample drawn_from(const Distribution& distribution, std::size_t count, std::uint64_t seed);

/// What is seen of the sample where the test ends at `limit`.
Sample ended_at(double limit, Sample sample);

/// draw(random) `count` times on all cores, each with random numbers of its own.
std::vector<double> simulated(std::size_t count, const std::function<double(Random&)>& draw);

/// The value below which a share of the values is.
double quantile_of(std::vector<double> values, double share);

double mean_of(const std::vector<double>& values);

/// Largest distance of the values from a uniform distribution over 0 .. 1, times sqrt(n); above
/// 1.63 with a chance of 1 %.
double distance_from_uniform(std::vector<double> values);

/// Fewer samples where instrumentation makes each of them slow.
std::size_t fewer_if_sanitized(std::size_t count);

}  // namespace host_sim::statistics
