#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace host_sim {

/// Finds samples that are missing between two that are there.
class SampleClock {
 public:
  explicit SampleClock(double period_s) : period_s_(period_s) {}

  /// Samples that are missing before this time.
  std::uint32_t missing_before(double time_s) {
    std::uint32_t missing = 0;
    if (ticks_ != 0) {
      const double periods = (time_s - time_s_) / period_s_;
      if (periods > 1.5) {
        missing = static_cast<std::uint32_t>(std::min(std::round(periods) - 1, 4e9));
        ++gaps_;
      }
    } else {
      first_s_ = time_s;
    }
    ++ticks_;
    time_s_ = time_s;
    return missing;
  }

  [[nodiscard]] double duration_s() const { return ticks_ == 0 ? 0 : time_s_ - first_s_; }
  [[nodiscard]] std::uint64_t samples() const { return ticks_; }
  /// True where the profile was not recorded at the rate of the model.
  [[nodiscard]] bool other_rate() const { return ticks_ > 2 && 2 * gaps_ > ticks_; }
  [[nodiscard]] double rate_Hz() const {
    return duration_s() > 0 ? static_cast<double>(ticks_ - 1) / duration_s() : 0;
  }

 private:
  double period_s_;
  double first_s_ = 0;
  double time_s_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint64_t gaps_ = 0;
};

}  // namespace host_sim
