#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host_sim/effects/tension_effect.hpp"
#include "host_sim/recording/covariates.hpp"

/// What the columns of signatures are made of.
namespace host_sim::effects {

/// One column: `value(i)` of each sample.
template <typename Value>
std::vector<double> column_of(const recording::Covariates& covariates, Value&& value) {
  std::vector<double> column(covariates.samples());
  for (std::size_t i = 0; i < column.size(); ++i) {
    column[i] = value(i);
  }
  return column;
}

/// phi s of a sample, what friction terms multiply.
inline double angle_and_direction(const recording::Covariates& covariates, std::size_t i) {
  return covariates.bend_angle_rad[i] * covariates.direction[i];
}

/// The share of the input end in the noise of r; a half where that is not known.
inline double input_noise_share(const recording::Covariates& covariates, std::size_t i) {
  constexpr double kLeastOfEnd = 0.02;
  if (covariates.input_noise.empty()) {
    return 0.5;
  }
  const double both = covariates.input_noise[i] + covariates.output_noise[i];
  return both > 0 ? std::clamp(covariates.input_noise[i] / both, kLeastOfEnd, 1 - kLeastOfEnd)
                  : 0.5;
}

/// ln of what to multiply a measured input by, tension or current, where a signature divides by it:
/// w r, T_in as the output gives it over T_in as measured by the share w of the input end in
/// their noise. The noise of both ends is part of r; a signature made of a tension whose noise goes
/// with that of r would find an effect where there is none. Between both ends, by each one's own
/// noise, lies the one tension whose noise does not. 0 where the baseline holds exactly.
inline double log_to_mid_tension(const recording::Covariates& covariates, const Baseline& baseline,
                                 std::size_t i) {
  const double grip =
      baseline.friction_coefficient * covariates.bend_angle_rad[i] * covariates.direction[i];
  return input_noise_share(covariates, i) *
         (std::log(covariates.output_tension_N[i] / covariates.tension_in_N()[i]) + grip);
}

inline double to_mid_tension(const recording::Covariates& covariates, const Baseline& baseline,
                             std::size_t i) {
  return std::exp(log_to_mid_tension(covariates, baseline, i));
}

/// r where T_in less what the output gives of it is q times the tension between both, so that
/// exp(-w r) - exp((1 - w) r) = q. For w = 1/2 that is -2 asinh(q/2), which Newton's steps start
/// at.
inline double log_of_difference(double q, double share) {
  constexpr int kSteps = 4;
  constexpr double kMost = 6;
  constexpr double kSettled = 1e-9;  // the next step is below the precision of a double
  double r = -2 * std::asinh(q / 2);
  if (share == 0.5) {
    return r;
  }
  for (int step = 0; step < kSteps; ++step) {
    const double input = std::exp(-share * r);
    const double output = std::exp((1 - share) * r);
    const double change = (input - output - q) / (share * input + (1 - share) * output);
    r = std::clamp(r + change, -kMost, kMost);
    if (std::abs(change) < kSettled) {
      break;
    }
  }
  return r;
}

/// Whether the tendon turns between the sample before and this one.
inline bool turns_at(const recording::Covariates& covariates, std::size_t i) {
  return i > 0 && covariates.direction[i] != covariates.direction[i - 1];
}

/// When within the step to sample i the motion turned, as a share of the step: where the velocity,
/// taken as linear, is zero.
inline double turned_at(const recording::Covariates& covariates, std::size_t i) {
  const double before = std::abs(covariates.velocity_m_s[i - 1]);
  const double after = std::abs(covariates.velocity_m_s[i]);
  return before + after > 0 ? before / (before + after) : 0.5;
}

/// The friction that a reversal turns over: of the recording by itself where that is known, as its
/// jumps do not follow what a session's friction is off by along the way.
inline double friction_at_reversals(const recording::Covariates& covariates,
                                    const Baseline& baseline) {
  return recording::plausible_friction(covariates.settled_friction, baseline.friction_coefficient);
}

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
