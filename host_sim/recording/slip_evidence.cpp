#include <algorithm>
#include <cmath>

#include "host_sim/recording/fault_rules.hpp"

namespace host_sim::recording {
namespace {

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

}  // namespace host_sim::recording
