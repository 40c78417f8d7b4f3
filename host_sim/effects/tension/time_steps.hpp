#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "host_sim/recording/covariates.hpp"

namespace host_sim::effects {

/// Steps of time between samples. Where a few are missing, as near a standstill, the motion goes
/// on; after a long pause nothing is known of what was before.
class TimeSteps {
 public:
  explicit TimeSteps(const recording::Covariates& covariates) : time_s_(covariates.time_s) {
    std::vector<double> steps_s;
    for (std::size_t i = 1; i < time_s_.size(); ++i) {
      steps_s.push_back(before_s(i));
    }
    if (!steps_s.empty()) {
      const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
      std::nth_element(steps_s.begin(), middle, steps_s.end());
      usual_s_ = *middle;
    }
  }

  [[nodiscard]] double before_s(std::size_t i) const { return time_s_[i] - time_s_[i - 1]; }
  [[nodiscard]] bool starts(std::size_t i) const {
    return i == 0 || before_s(i) > kPause * usual_s_;
  }
  [[nodiscard]] bool gap(std::size_t i) const { return before_s(i) > kGap * usual_s_; }

 private:
  static constexpr double kGap = 1.5;
  static constexpr double kPause = 100;

  const std::vector<double>& time_s_;
  double usual_s_ = 0;
};

}  // namespace host_sim::effects
