#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <span>
#include <vector>

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::statistics {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Specimens that all failed.
Sample failed(std::initializer_list<double> lives);

/// Specimens that failed or were suspended.
Sample with_suspended(std::initializer_list<double> failed_lives,
                      std::initializer_list<double> suspended_lives);

/// `count` quantiles of a Weibull distribution in the middle of equal shares: a sample that looks
/// like it, without random numbers.
Sample ideal_weibull(double scale, double shape, std::size_t count);

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

}  // namespace host_sim::statistics

namespace host_sim::statistics::published {

/// Endurance of 23 deep-groove ball bearings in 10^6 revolutions: Lieblein and Zelen, J. Res. Natl.
/// Bur. Stand. 57 (1956) 273. Reprints differ in the seventh life, 48.40 or 48.48; this is 48.40.
Sample ball_bearings();

/// Service of 70 diesel generator fans in 1000 hours, 12 failed: Nelson, Applied Life Data Analysis
/// (1982), p. 318.
Sample generator_fans();

/// 20 units in hours, 10 suspended at 500: NIST/SEMATECH e-Handbook of Statistical
/// Methods, 8.4.1.3.
Sample nist_units();

/// 38 vehicle shock absorbers in km, 11 failed, both modes: Meeker and Escobar, Statistical Methods
/// for Reliability Data (1998), p. 630.
Sample shock_absorbers();

/// 72 fatigue specimens of alloy T7987 in 1000 cycles, 5 suspended at 300: Meeker and Escobar
/// (1998), p. 131, as R package weibulltools 2.1.0 holds them. SAS reprints the second 152 as 153.
Sample alloy_t7987();

}  // namespace host_sim::statistics::published
