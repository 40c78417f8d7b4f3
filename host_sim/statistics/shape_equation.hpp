#pragma once

#include <span>

#include "host_sim/statistics/centred_sample.hpp"

namespace host_sim::statistics {

/// What keeps the samples from having a shape in common: too_few_failures (fewer than two in all)
/// or no_spread (no sample has any).
FitProblem shape_problem(std::span<const CentredSample> samples);

/// The Weibull shape of several samples with scales of their own: root of eq. (16), the censored
/// likelihood equation, over samples of logarithms. Samples without failures say nothing.
/// @pre shape_problem is none
/// @return 0 where it did not converge
double solve_shape(std::span<const CentredSample> samples);

/// ln alpha of one sample at a shape. +infinity without failures.
double log_scale(const CentredSample& sample, double shape);

/// Log likelihood of the samples at a shape, each with its best scale.
double shape_log_likelihood(std::span<const CentredSample> samples, double shape);

}  // namespace host_sim::statistics
