#include "host_sim/statistics/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {
namespace {

Observation seen_of(double life, double limit) {
  return {.value = std::min(life, limit), .failed = life <= limit};
}

/// The limits are what "fails" here, and a failure only says that its limit is not below its life.
/// At one life failures come first, so that they do not dilute the limits that are there.
Sample limits_as_failures(std::span<const Observation> sample) {
  Sample result(sample.begin(), sample.end());
  std::sort(result.begin(), result.end(), rises_failures_first);
  for (Observation& seen : result) {
    seen.failed = !seen.failed;
  }
  return result;
}

}  // namespace

CensoringPlan::CensoringPlan(std::span<const Observation> sample)
    : sample_(sample.begin(), sample.end()) {
  KaplanMeier estimate;
  estimate.assign_in_order(limits_as_failures(sample));
  for (const KaplanMeier::Step& step : estimate.steps()) {
    limits_.push_back(step.value);
    limit_survival_.push_back(1 - step.after);
  }
}

double CensoringPlan::limit_of(const Observation& specimen, Random& random) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (!specimen.failed) {
    return specimen.value;
  }
  const auto first = std::lower_bound(limits_.begin(), limits_.end(), specimen.value);
  if (first == limits_.end()) {
    return kNone;
  }
  const auto skipped = first - limits_.begin();
  const double survival_before =
      skipped == 0 ? 1 : limit_survival_[static_cast<std::size_t>(skipped - 1)];
  const double drawn = random.uniform() * survival_before;
  for (auto i = static_cast<std::size_t>(skipped); i < limits_.size(); ++i) {
    if (limit_survival_[i] < drawn) {
      return limits_[i];
    }
  }
  return kNone;
}

void CensoringPlan::draw(const Distribution& truth, Random& random, Sample& drawn) const {
  drawn.resize(sample_.size());
  for (std::size_t i = 0; i < sample_.size(); ++i) {
    const double life = truth.quantile(random.uniform());
    drawn[i] = seen_of(life, limit_of(sample_[i], random));
  }
}

void CensoringPlan::observe(std::span<const double> lives, Random& random, Sample& seen) const {
  seen.resize(sample_.size());
  for (std::size_t i = 0; i < sample_.size(); ++i) {
    seen[i] = seen_of(lives[i], limit_of(sample_[i], random));
  }
}

double bootstrap_p(std::span<const double> replicates, double observed) {
  double computed = 0;
  double exceeding = 0;
  for (const double replicate : replicates) {
    computed += std::isnan(replicate) ? 0 : 1;
    exceeding += replicate >= observed ? 1 : 0;
  }
  if (computed == 0 || std::isnan(observed)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return (1 + exceeding) / (1 + computed);
}

}  // namespace host_sim::statistics
