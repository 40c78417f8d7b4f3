#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim::statistics {

struct Interval {
  double low = 0;
  double high = 0;
};

/// A likelihood-ratio test. What was not computed is NaN: everything where a sample that takes part
/// has its failures at one life, or where fewer than two take part.
struct Test {
  double statistic = 0;  ///< 2 (log L1 - log L0)
  double degrees_of_freedom = 0;
  double p_chi_square = 0;
  double p_simulated = 0;
};

/// One Weibull shape for several samples with scales of their own.
struct CommonShapeFit {
  double shape = 0;            ///< root of eq. (16)
  std::vector<double> scales;  ///< one for each sample
  double log_likelihood = 0;
  FitProblem problem = FitProblem::none;
};

/// Samples without failures have no scale (+infinity) and say nothing of the shape.
CommonShapeFit fit_common_shape(std::span<const Sample> samples);

/// Profile-likelihood interval of the common shape.
Interval common_shape_interval(std::span<const Sample> samples, const CommonShapeFit& fit,
                               double confidence);

/// One shape against a shape for each sample: eqs. (17) and (18) with the factor 2 that they have.
/// Samples with fewer than two failures take no part. p_simulated from replicates of the common
/// fit under each sample's plan of suspension.
Test test_common_shape(std::span<const Sample> samples, const BootstrapOptions& options);

struct ShapeTests {
  Test common;  ///< test_common_shape()
  /// One shape for all against one for this sample and another for the rest: one degree of freedom.
  std::vector<Test> one_against_rest;
};

/// All of these tests by the same replicates.
ShapeTests test_shapes(std::span<const Sample> samples, const BootstrapOptions& options);

/// The shape without its bias, by simulation: the estimate over the mean of (estimate / truth).
double unbiased_shape(std::span<const Sample> samples, const CommonShapeFit& fit,
                      const BootstrapOptions& options);

}  // namespace host_sim::statistics
