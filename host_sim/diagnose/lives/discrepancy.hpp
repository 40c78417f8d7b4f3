#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"

namespace host_sim::diagnose::lives {

/// Residual of one specimen: standard exponential, censored where it did not fail.
struct CoxSnell {
  double value = 0;
  bool failed = true;

  /// Failures less those expected: mean 0.
  [[nodiscard]] double excess() const { return (failed ? 1 : 0) - value; }
};

/// A score of the residuals against one covariate.
struct CovariateStatistic {
  std::string covariate;
  /// Large where the residuals depend on the covariate.
  std::function<double(std::span<const CoxSnell>)> statistic;
};

/// Those that a sample allows. The sample must outlive this.
std::vector<CovariateStatistic> covariate_statistics(const LifeSample& sample);

/// Its value, with how seldom the nominal law gives as much.
struct CovariateTest {
  std::string covariate;
  double statistic = 0;
  double p = 1;
};

struct Omnibus {
  std::vector<CovariateTest> tests;
  double p = 1;  ///< of the largest of all, each in units of its own replicates
};

struct OmnibusOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;
  std::size_t replicates = 1000;
};

/// Tests the Cox-Snell residuals of the nominal law, refitted, against each covariate: rest of
/// the scatter between loads, lots and groups, curvature, shape by level, days, ratio of wire to
/// bend, mean tension, order of blocks, and the distribution of the residuals, of one level as a
/// whole. p by the parametric bootstrap: lives drawn from the fit under the campaign's own plan of
/// suspension, refitted.
Omnibus omnibus_test(const LifeSample& sample, const OmnibusOptions& options);

/// The lives as they would be without what a model adds to the nominal law, for another test: each
/// at one load, with damage cox_snell^(1/shape) by the nominal law.
LifeSample without_effects(const LifeSample& sample, const std::vector<double>& cox_snell);

}  // namespace host_sim::diagnose::lives
