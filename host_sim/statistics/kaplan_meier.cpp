#include "host_sim/statistics/kaplan_meier.hpp"

#include <algorithm>

namespace host_sim::statistics {

bool rises_failures_first(const Observation& left, const Observation& right) {
  return left.value < right.value || (left.value == right.value && left.failed && !right.failed);
}

void KaplanMeier::assign(std::span<const Observation> sample) {
  sorted_.assign(sample.begin(), sample.end());
  std::sort(sorted_.begin(), sorted_.end(), rises_failures_first);
  assign_in_order(sorted_);
}

void KaplanMeier::assign_in_order(std::span<const Observation> sample) {
  steps_.clear();
  size_ = static_cast<double>(sample.size());
  last_ = sample.empty() ? 0 : sample.back().value;
  double at_risk = size_;
  double survival = 1;
  for (const Observation& seen : sample) {
    if (seen.failed) {
      const double before = 1 - survival;
      survival *= (at_risk - 1) / at_risk;
      if (!steps_.empty() && steps_.back().value == seen.value) {
        steps_.back().after = 1 - survival;
      } else {
        steps_.push_back({.value = seen.value, .before = before, .after = 1 - survival});
      }
    }
    --at_risk;
  }
}

}  // namespace host_sim::statistics
