#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace host_sim::reference {

/// Reduces a tension signal to its turning points, ignoring swings smaller than the hysteresis.
///
/// A turning point is confirmed once the signal has come back from the running extremum by at least
/// the hysteresis; with none, by anything at all. The first turning point is the earlier of the
/// running maximum and minimum as soon as these are one hysteresis apart. Swings are compared with
/// (1 - 1e-9) of the hysteresis, so that one written in decimals counts as what was written.
class TurningPointFilter {
 public:
  /// @param hysteresis_N >= 0
  explicit TurningPointFilter(double hysteresis_N)
      : threshold_N_(
            std::max(hysteresis_N * (1.0 - 1e-9), std::numeric_limits<double>::denorm_min())) {}

  /// Takes the next sample (finite) and returns the turning point that it confirms, if any.
  std::optional<double> push(double tension_N) {
    switch (phase_) {
      case Phase::kRising:
        if (tension_N > high_N_) {
          high_N_ = tension_N;
        } else if (high_N_ - tension_N >= threshold_N_) {
          phase_ = Phase::kFalling;
          low_N_ = tension_N;
          return high_N_;
        }
        return std::nullopt;
      case Phase::kFalling:
        if (tension_N < low_N_) {
          low_N_ = tension_N;
        } else if (tension_N - low_N_ >= threshold_N_) {
          phase_ = Phase::kRising;
          high_N_ = tension_N;
          return low_N_;
        }
        return std::nullopt;
      case Phase::kEmpty:
        phase_ = Phase::kUndecided;
        high_N_ = tension_N;
        low_N_ = tension_N;
        return std::nullopt;
      case Phase::kUndecided:
        return decide(tension_N);
    }
    return std::nullopt;
  }

  /// The extremum that the signal has not yet come back from; none before the first turning point.
  std::optional<double> unconfirmed() const {
    switch (phase_) {
      case Phase::kRising:
        return high_N_;
      case Phase::kFalling:
        return low_N_;
      case Phase::kEmpty:
      case Phase::kUndecided:
        break;
    }
    return std::nullopt;
  }

 private:
  enum class Phase { kEmpty, kUndecided, kRising, kFalling };

  std::optional<double> decide(double tension_N) {
    if (tension_N > high_N_) {
      high_N_ = tension_N;
      if (high_N_ - low_N_ >= threshold_N_) {
        phase_ = Phase::kRising;
        return low_N_;
      }
    } else if (tension_N < low_N_) {
      low_N_ = tension_N;
      if (high_N_ - low_N_ >= threshold_N_) {
        phase_ = Phase::kFalling;
        return high_N_;
      }
    }
    return std::nullopt;
  }

  double threshold_N_;
  Phase phase_ = Phase::kEmpty;
  double high_N_ = 0.0;
  double low_N_ = 0.0;
};

}  // namespace host_sim::reference
