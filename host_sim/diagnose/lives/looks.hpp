#pragma once

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

struct LookAt {
  std::string covariate;
  /// Large where the residuals depend on the covariate.
  std::function<double(std::span<const CoxSnell>)> statistic;
};

/// What a sample can be looked at for. The sample must outlive this.
std::vector<LookAt> looks_of(const LifeSample& sample);

}  // namespace host_sim::diagnose::lives
