#include "host_sim/recording/fault_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/io/printable.hpp"

namespace host_sim::recording {
namespace {

constexpr std::string_view kSamplesOut = "these samples are left out";

std::string_view name_of(ProfileColumnId channel) {
  return profile_columns()[channel].name;
}

std::string value_text(ProfileColumnId channel, double value) {
  return channel == kTendonVelocity
             ? fmt::format("{:g} m/s", value)
             : fmt::format("{:g} {}", value, profile_columns()[channel].unit);
}

std::string session_text(const Recording& recording) {
  return fmt::format("session {}", in_quotes(recording.session));
}

std::string time_text(const Recording& recording, const Stretch& stretch) {
  const std::vector<double>& time_s = recording[kTime];
  return fmt::format("from {:g} s to {:g} s", time_s[stretch.first], time_s[stretch.end() - 1]);
}

}  // namespace

std::string gap_words(const Recording& recording, const Stretch& gap) {
  const std::vector<double>& time_s = recording[kTime];
  return fmt::format(
      "{}: no samples from {:g} s to {:g} s; direction and travel are taken up anew behind the gap",
      session_text(recording), time_s[gap.first - 1], time_s[gap.first]);
}

std::string constant_words(const Recording& recording, ProfileColumnId channel) {
  const std::string value = value_text(channel, recording[channel].front());
  return fmt::format("{}: {} is {} in all samples; the channel is left out as if not recorded",
                     session_text(recording), name_of(channel), value);
}

std::string stuck_words(const Recording& recording, const LiveChannel& channel,
                        const Stretch& stretch) {
  const bool noisy = channel.sensor.longest_by_chance != 0;
  return fmt::format(
      "{}: {} is stuck at {} {}, {}; {}", session_text(recording), name_of(channel.id),
      value_text(channel.id, channel.values[stretch.first]), time_text(recording, stretch),
      noisy ? "without the noise that it has elsewhere" : "while other channels show motion",
      kSamplesOut);
}

std::string saturated_words(const Recording& recording, const LiveChannel& channel,
                            const Stretch& stretch) {
  const double value = channel.values[stretch.first];
  return fmt::format("{}: {} stays at {}, its {} value, {}: saturated; {}", session_text(recording),
                     name_of(channel.id), value_text(channel.id, value),
                     value == channel.sensor.highest ? "largest" : "smallest",
                     time_text(recording, stretch), kSamplesOut);
}

std::string not_positive_words(const Recording& recording, const LiveChannel& channel,
                               const Stretch& stretch) {
  const bool always = channel.sensor.highest <= least_positive(channel.sensor);
  const auto values = channel.values.subspan(stretch.first, stretch.count);
  return fmt::format("{}: {} goes down to {} {}, where it has no logarithm above its noise{}; {}",
                     session_text(recording), name_of(channel.id),
                     value_text(channel.id, *std::min_element(values.begin(), values.end())),
                     time_text(recording, stretch),
                     always ? " (it is never above: is its sign the other way round?)" : "",
                     kSamplesOut);
}

}  // namespace host_sim::recording
