#include <algorithm>
#include <cmath>

#include "host_sim/recording/fault_rules.hpp"
#include "host_sim/recording/integral.hpp"

namespace host_sim::recording {
namespace {

constexpr double kShareOfRange = 0.3;
constexpr double kLeast_s = 0.25;
constexpr std::size_t kLeastSamples = 50;

/// What moves while the sensor stands still.
class Witnesses {
 public:
  Witnesses(const LiveChannel& channel, const SessionView& session)
      : session_(session), channel_(channel), id_(channel.id) {
    const auto velocity =
        std::find_if(session.channels.begin(), session.channels.end(),
                     [](const LiveChannel& other) { return other.id == kTendonVelocity; });
    if (id_ == kMotorAngle && velocity != session.channels.end()) {
      path_m_ = integral(session.time_s, velocity->values);
      const auto [lowest, highest] = std::minmax_element(path_m_.begin(), path_m_.end());
      path_range_m_ = *highest - *lowest;
    }
  }

  bool contradict(const Stretch& stretch) const {
    return goes_away(stretch) ||
           std::any_of(session_.channels.begin(), session_.channels.end(),
                       [&](const LiveChannel& other) { return contradicts(other, stretch); });
  }

 private:
  bool contradicts(const LiveChannel& other, const Stretch& stretch) const {
    if (is_load(id_) && is_load(other.id) && other.id != id_ && other.sensor.span() > 0) {
      const double share = std::max(rise_in_slip(other, stretch, session_.slips),
                                    fall_in_slip(other, stretch, session_.slips));
      return share >= kShareOfRange &&
             has_to_show(channel_, channel_.values[stretch.first], other, share);
    }
    return id_ == kTendonVelocity && other.id == kMotorAngle && other.sensor.span() > 0 &&
           swing_in(other.values, stretch) >= kShareOfRange * other.sensor.span();
  }

  bool goes_away(const Stretch& stretch) const {
    if (path_m_.empty()) {
      return false;
    }
    double furthest_m = 0;
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      furthest_m = std::max(furthest_m, std::abs(path_m_[i] - path_m_[stretch.first]));
    }
    return furthest_m > 0 && furthest_m >= kShareOfRange * path_range_m_;
  }

  const SessionView& session_;
  const LiveChannel& channel_;
  ProfileColumnId id_;
  std::vector<double> path_m_;  ///< of the tendon, for a motor angle
  double path_range_m_ = 0;
};

bool may_be_stuck(const LiveChannel& channel, const Stretch& stretch,
                  std::span<const double> time_s) {
  const double value = channel.values[stretch.first];
  return time_s[stretch.end() - 1] - time_s[stretch.first] >= kLeast_s &&
         value != channel.sensor.highest && value != channel.sensor.lowest &&
         (channel.id != kTendonVelocity || value != 0);
}

}  // namespace

bool is_load(ProfileColumnId id) {
  return id == kInputTensionColumn || id == kMotorCurrentColumn || id == kOutputTensionColumn;
}

bool has_to_change(ProfileColumnId id) {
  return is_load(id) || id == kTendonVelocity || id == kMotorAngle;
}

std::vector<Stretch> stuck_in(const LiveChannel& channel, const SessionView& session) {
  const Witnesses witnesses(channel, session);
  std::vector<Stretch> stuck;
  for (const Stretch& stretch : still_stretches(channel.values, kLeastSamples)) {
    if (may_be_stuck(channel, stretch, session.time_s) &&
        (channel.sensor.longest_by_chance != 0 || witnesses.contradict(stretch))) {
      stuck.push_back(stretch);
    }
  }
  return stuck;
}

}  // namespace host_sim::recording
