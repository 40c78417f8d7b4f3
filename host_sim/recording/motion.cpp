#include "host_sim/recording/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/recording/sensor.hpp"

namespace host_sim::recording {
namespace {

/// Follows the tendon through one stretch after the other.
class Follower {
 public:
  Follower(std::span<const double> time_s, std::span<const double> velocity_m_s, double band_m_s)
      : time_s_(time_s), velocity_m_s_(velocity_m_s), band_m_s_(band_m_s) {
    const std::size_t samples = time_s.size();
    motion_.direction.assign(samples, 1);
    motion_.travel_m.assign(samples, 0);
    motion_.reversals.assign(samples, 0);
    motion_.known.assign(samples, false);
    turning_.assign(samples, false);
  }

  void follow(const Stretch& stretch) {
    const std::size_t first_motion = find_directions(stretch);
    double travel_m = 0;
    bool turned = false;
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      const double direction = motion_.direction[i];
      if (moved_ && direction != last_direction_) {
        ++reversals_;
        travel_m = i > stretch.first ? since_turn_m(i) : 0;
        turned = turned || i > first_motion;
        turning_[i] = true;
        if (i > stretch.first) {
          motion_.known[i - 1] = false;
        }
      } else if (i > first_motion) {
        travel_m += step_m(i) * direction;
      }
      last_direction_ = direction;
      moved_ = moved_ || i >= first_motion;
      motion_.travel_m[i] = std::max(travel_m, 0.0);
      motion_.reversals[i] = reversals_;
      motion_.known[i] =
          i >= first_motion && !turning_[i] && (turned || travel_m >= kSettledTravel_m);
    }
  }

  /// Before the first stretch and between stretches the counts stand.
  Motion finish() {
    double reversals = 0;
    for (double& count : motion_.reversals) {
      reversals = std::max(reversals, count);
      count = reversals;
    }
    return std::move(motion_);
  }

 private:
  double step_m(std::size_t i) const {
    return (velocity_m_s_[i] + velocity_m_s_[i - 1]) / 2 * (time_s_[i] - time_s_[i - 1]);
  }

  /// Travel to sample i since the velocity, taken as linear, was zero in the step before it.
  double since_turn_m(std::size_t i) const {
    const double speed_m_s = std::abs(velocity_m_s_[i]);
    const double both_m_s = speed_m_s + std::abs(velocity_m_s_[i - 1]);
    const double since_s =
        both_m_s > 0 ? speed_m_s / both_m_s * (time_s_[i] - time_s_[i - 1]) : 0.0;
    return speed_m_s * since_s / 2;
  }

  /// Returns the sample at which the stretch begins to move, its end if it does not.
  std::size_t find_directions(const Stretch& stretch) {
    double direction = 0;
    double direction_before = last_direction_;
    std::size_t first_motion = stretch.end();
    std::size_t filled = stretch.first;
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      const double sign = velocity_m_s_[i] > 0 ? 1 : -1;
      if (std::abs(velocity_m_s_[i]) <= band_m_s_ || sign == direction) {
        continue;
      }
      direction = sign;
      mark_turning(stretch.first, i);
      const std::size_t from = first_of_sign(filled, i, sign);
      first_motion = std::min(first_motion, from);
      fill(filled, from, direction_before);
      filled = from;
      direction_before = sign;
    }
    fill(filled, stretch.end(), direction_before);
    mark_end(stretch, direction_before);
    return first_motion;
  }

  /// The samples before `end` that do not show which way the tendon went.
  void mark_turning(std::size_t first, std::size_t end) {
    for (std::size_t i = end; i > first && std::abs(velocity_m_s_[i - 1]) <= band_m_s_; --i) {
      turning_[i - 1] = true;
    }
  }

  /// A turn that the end of the stretch cuts off before the dead band is left, and the sample
  /// before it.
  void mark_end(const Stretch& stretch, double direction) {
    std::size_t i = stretch.end();
    while (i > stretch.first && std::abs(velocity_m_s_[i - 1]) <= band_m_s_) {
      --i;
    }
    while (i < stretch.end() && velocity_m_s_[i] * direction >= 0) {
      ++i;
    }
    if (i > stretch.first && i < stretch.end()) {
      --i;
    }
    std::fill(turning_.begin() + static_cast<std::ptrdiff_t>(i),
              turning_.begin() + static_cast<std::ptrdiff_t>(stretch.end()), true);
  }

  void fill(std::size_t from, std::size_t end, double direction) {
    std::fill(motion_.direction.begin() + static_cast<std::ptrdiff_t>(from),
              motion_.direction.begin() + static_cast<std::ptrdiff_t>(end), direction);
  }

  std::size_t first_of_sign(std::size_t first, std::size_t i, double sign) const {
    while (i > first && velocity_m_s_[i - 1] * sign > 0) {
      --i;
    }
    return i;
  }

  std::span<const double> time_s_, velocity_m_s_;
  double band_m_s_;
  Motion motion_;
  std::vector<bool> turning_;
  bool moved_ = false;  ///< in any stretch so far
  double last_direction_ = 1;
  double reversals_ = 0;
};

}  // namespace

double dead_band_m_s(std::span<const double> velocity_m_s) {
  if (velocity_m_s.empty()) {
    return 0;
  }
  std::vector<double> speeds_m_s;
  for (const double velocity : velocity_m_s) {
    speeds_m_s.push_back(std::abs(velocity));
  }
  double top_m_s = quantile(speeds_m_s, 0.99);
  if (top_m_s == 0) {
    top_m_s = quantile(std::move(speeds_m_s), 1);
  }
  return std::max({std::min(4 * noise_sigma(velocity_m_s), top_m_s / 4),
                   std::min(resolution(velocity_m_s), top_m_s / 20), top_m_s / 200});
}

Motion motion_of(std::span<const double> time_s, std::span<const double> velocity_m_s,
                 std::span<const Stretch> stretches, double dead_band_m_s) {
  Follower follower(time_s, velocity_m_s, dead_band_m_s);
  for (const Stretch& stretch : stretches) {
    follower.follow(stretch);
  }
  return follower.finish();
}

std::vector<Stretch> slips_of(const Motion& motion) {
  std::vector<bool> settled(motion.travel_m.size());
  for (std::size_t i = 0; i < settled.size(); ++i) {
    settled[i] = motion.known[i] && motion.travel_m[i] >= kSettledTravel_m;
  }
  return stretches_of(settled, true);
}

}  // namespace host_sim::recording
