#include <algorithm>

#include "host_sim/recording/fault_rules.hpp"

namespace host_sim::recording {
namespace {

constexpr std::size_t kLeastSamples = 5;

constexpr double kShareOfRange = 0.1;

bool goes_on(const LiveChannel& channel, const LiveChannel& other, const Stretch& stretch,
             bool at_highest, std::span<const Stretch> slips) {
  const double share =
      at_highest ? rise_in_slip(other, stretch, slips) : fall_in_slip(other, stretch, slips);
  return share >= kShareOfRange &&
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
  for (const Stretch& stretch : still_stretches(channel.values, kLeastSamples)) {
    const double value = channel.values[stretch.first];
    if ((value == channel.sensor.highest || value == channel.sensor.lowest) &&
        is_saturated(channel, stretch, session)) {
      saturated.push_back(stretch);
    }
  }
  return saturated;
}

}  // namespace host_sim::recording
