#pragma once

#include <initializer_list>
#include <span>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {

/// Specimens that all failed.
Sample failed(std::initializer_list<double> lives);

/// Specimens that failed or were suspended.
Sample with_suspended(std::initializer_list<double> failed_lives,
                      std::initializer_list<double> suspended_lives);

/// `count` quantiles of a Weibull distribution in the middle of equal shares: a sample that looks
/// like it, without random numbers.
Sample ideal_weibull(double scale, double shape, std::size_t count);

}  // namespace host_sim::statistics
