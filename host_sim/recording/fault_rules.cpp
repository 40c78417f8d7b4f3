#include "host_sim/recording/fault_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/recording/sensor.hpp"
#include "host_sim/recording/signal.hpp"

namespace host_sim::recording {

using enum hal::files::ProfileColumnId;
using hal::files::ProfileColumnId;

std::vector<Stretch> gaps_in(std::span<const double> time_s) {
  constexpr double kSteps = 5.5;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    steps_s.push_back(time_s[i] - time_s[i - 1]);
  }
  std::vector<Stretch> gaps;
  if (steps_s.empty()) {
    return gaps;
  }
  const double most_s = kSteps * quantile(steps_s, 0.5);
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (steps_s[i] > most_s) {
      gaps.push_back({i + 1, 1});
    }
  }
  return gaps;
}

namespace {

/// Whether it is a tension or the current that stands for one.
bool is_load(ProfileColumnId id) {
  return id == kInputTensionColumn || id == kMotorCurrentColumn || id == kOutputTensionColumn;
}

using Excursion = double (*)(std::span<const double>, const Stretch&);

double largest_share(const LiveChannel& channel, const Stretch& stretch,
                     std::span<const Stretch> slips, Excursion excursion) {
  constexpr double kNoise = 6;
  auto slip = std::partition_point(slips.begin(), slips.end(), [&](const Stretch& before) {
    return before.end() <= stretch.first;
  });
  double largest = 0;
  for (; slip != slips.end() && slip->first < stretch.end(); ++slip) {
    const std::size_t first = std::max(slip->first, stretch.first);
    const std::size_t end = std::min(slip->end(), stretch.end());
    largest = std::max(largest, excursion(channel.values, {first, end - first}));
  }
  return (largest - kNoise * channel.sensor.noise_sigma) / channel.sensor.span();
}

}  // namespace

double rise_in_slip(const LiveChannel& channel, const Stretch& stretch,
                    std::span<const Stretch> slips) {
  return largest_share(channel, stretch, slips, rise_in);
}

double fall_in_slip(const LiveChannel& channel, const Stretch& stretch,
                    std::span<const Stretch> slips) {
  return largest_share(channel, stretch, slips, fall_in);
}

bool has_to_show(const LiveChannel& channel, double value, const LiveChannel& other, double share) {
  constexpr double kSteps = 4;
  const double level = std::max(std::abs(other.sensor.highest), std::abs(other.sensor.lowest));
  return share * other.sensor.span() * std::abs(value) >=
         kSteps * channel.sensor.resolution * level;
}

namespace {

constexpr double kShareWhileStuck = 0.3;
constexpr double kLeastStuck_s = 0.25;
constexpr std::size_t kLeastStuckSamples = 50;

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
      return share >= kShareWhileStuck &&
             has_to_show(channel_, channel_.values[stretch.first], other, share);
    }
    return id_ == kTendonVelocity && other.id == kMotorAngle && other.sensor.span() > 0 &&
           swing_in(other.values, stretch) >= kShareWhileStuck * other.sensor.span();
  }

  bool goes_away(const Stretch& stretch) const {
    if (path_m_.empty()) {
      return false;
    }
    double furthest_m = 0;
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      furthest_m = std::max(furthest_m, std::abs(path_m_[i] - path_m_[stretch.first]));
    }
    return furthest_m > 0 && furthest_m >= kShareWhileStuck * path_range_m_;
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
  return time_s[stretch.end() - 1] - time_s[stretch.first] >= kLeastStuck_s &&
         value != channel.sensor.highest && value != channel.sensor.lowest &&
         (channel.id != kTendonVelocity || value != 0);
}

}  // namespace

bool has_to_change(ProfileColumnId id) {
  return is_load(id) || id == kTendonVelocity || id == kMotorAngle;
}

std::vector<Stretch> stuck_in(const LiveChannel& channel, const SessionView& session) {
  const Witnesses witnesses(channel, session);
  std::vector<Stretch> stuck;
  for (const Stretch& stretch : still_stretches(channel.values, kLeastStuckSamples)) {
    if (may_be_stuck(channel, stretch, session.time_s) &&
        (channel.sensor.longest_by_chance != 0 || witnesses.contradict(stretch))) {
      stuck.push_back(stretch);
    }
  }
  return stuck;
}

namespace {

constexpr std::size_t kLeastSaturatedSamples = 5;

constexpr double kShareWhileSaturated = 0.1;

bool goes_on(const LiveChannel& channel, const LiveChannel& other, const Stretch& stretch,
             bool at_highest, std::span<const Stretch> slips) {
  const double share =
      at_highest ? rise_in_slip(other, stretch, slips) : fall_in_slip(other, stretch, slips);
  return share >= kShareWhileSaturated &&
         has_to_show(channel, channel.values[stretch.first], other, share);
}

bool is_saturated(const LiveChannel& channel, const Stretch& stretch, const SessionView& session) {
  if (channel.id == kTendonVelocity && channel.values[stretch.first] == 0) {
    return false;
  }
  const std::size_t by_chance = channel.sensor.longest_by_chance;
  if (by_chance != 0 && stretch.count >= by_chance) {
    return true;
  }
  const bool at_highest = channel.values[stretch.first] == channel.sensor.highest;
  return is_load(channel.id) &&
         std::any_of(
             session.channels.begin(), session.channels.end(), [&](const LiveChannel& other) {
               return other.id != channel.id && is_load(other.id) && other.sensor.span() > 0 &&
                      goes_on(channel, other, stretch, at_highest, session.slips);
             });
}

}  // namespace

std::vector<Stretch> saturated_in(const LiveChannel& channel, const SessionView& session) {
  std::vector<Stretch> saturated;
  for (const Stretch& stretch : still_stretches(channel.values, kLeastSaturatedSamples)) {
    const double value = channel.values[stretch.first];
    if ((value == channel.sensor.highest || value == channel.sensor.lowest) &&
        is_saturated(channel, stretch, session)) {
      saturated.push_back(stretch);
    }
  }
  return saturated;
}

}  // namespace host_sim::recording
