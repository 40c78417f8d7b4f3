#pragma once

#include <span>
#include <vector>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {

/// Order of lives in which specimens that failed at a life come before those suspended there.
bool rises_failures_first(const Observation& left, const Observation& right);

/// Kaplan and Meier's estimate of the share that has failed. assign() again reuses the memory.
class KaplanMeier {
 public:
  /// A distinct life at which something failed.
  struct Step {
    double value = 0;
    double before = 0;  ///< share failed just before, 0 .. 1
    double after = 0;   ///< and with this life
  };

  void assign(std::span<const Observation> sample);
  /// The same of a sample in order of lives; of equal lives the earlier leaves the risk set first.
  void assign_in_order(std::span<const Observation> sample);

  [[nodiscard]] std::span<const Step> steps() const { return steps_; }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] double last() const { return last_; }  ///< largest observation
  /// All have failed at the last observation, so that the estimate goes on beyond it as 1.
  [[nodiscard]] bool complete() const { return !steps_.empty() && steps_.back().after == 1; }

 private:
  Sample sorted_;
  std::vector<Step> steps_;
  double size_ = 0;
  double last_ = 0;
};

}  // namespace host_sim::statistics
