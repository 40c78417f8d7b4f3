#pragma once

#include <span>
#include <vector>

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::statistics {

/// When specimens of one sample would have been suspended, for simulating samples like it. A
/// suspended specimen keeps its limit; one that failed gets a limit not below its life from the
/// Kaplan-Meier estimate of the limits, or none beyond the last (the conditional bootstrap; Davison
/// and Hinkley 1997, section 3.5). So all specimens of a test that ended at one life have that
/// limit.
class CensoringPlan {
 public:
  explicit CensoringPlan(std::span<const Observation> sample);

  /// A sample of the same size with lives out of `truth`, into `drawn`.
  void draw(const Distribution& truth, Random& random, Sample& drawn) const;

  /// The same with lives given by the caller: what is seen of `lives`, one for each specimen in the
  /// order of the sample that made the plan.
  void observe(std::span<const double> lives, Random& random, Sample& seen) const;

 private:
  [[nodiscard]] double limit_of(const Observation& specimen, Random& random) const;

  Sample sample_;
  std::vector<double> limits_;  ///< distinct, rising
  std::vector<double> limit_survival_;
};

}  // namespace host_sim::statistics
