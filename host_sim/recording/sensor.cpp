#include "host_sim/recording/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace host_sim::recording {

double quantile(std::vector<double> values, double q) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::lround(q * last));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double resolution(std::span<const double> values) {
  double least = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    if (step > 0 && (least == 0 || step < least)) {
      least = step;
    }
  }
  return least;
}

double noise_sigma(std::span<const double> values) {
  constexpr double kMedianOfNormal = 0.674489750196082;
  if (values.size() < 3) {
    return 0;
  }
  std::vector<double> bends;
  bends.reserve(values.size() - 2);
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    bends.push_back(std::abs(values[i - 1] - 2 * values[i] + values[i + 1]));
  }
  return quantile(std::move(bends), 0.5) / (kMedianOfNormal * std::sqrt(6.0));
}

namespace {

constexpr std::size_t kLongestOfCoarse = 50;
constexpr std::size_t kLongestOfFine = 8;

/// Samples outside of long rows of equal values, which may be the fault that is looked for, that
/// change least over 16 sample times: a tenth of all, at least 100.
std::vector<std::size_t> slow_samples(std::span<const double> values) {
  constexpr std::size_t kStride = 8;
  constexpr std::size_t kEnoughToJudge = 100;
  std::vector<bool> in_row(values.size());
  for (const Stretch& row : still_stretches(values, kLongestOfFine)) {
    std::fill_n(in_row.begin() + static_cast<std::ptrdiff_t>(row.first), row.count, true);
  }
  std::vector<std::pair<double, std::size_t>> samples;
  for (std::size_t i = kStride; i + kStride < values.size(); ++i) {
    if (!in_row[i - 1] && !in_row[i] && !in_row[i + 1]) {
      samples.emplace_back(std::abs(values[i + kStride] - values[i - kStride]), i);
    }
  }
  const std::size_t wanted = std::max(kEnoughToJudge, values.size() / 10);
  if (samples.size() > wanted) {
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(wanted),
                     samples.end());
    samples.resize(wanted);
  }
  std::vector<std::size_t> slow;
  if (samples.size() >= kEnoughToJudge) {
    std::transform(samples.begin(), samples.end(), std::back_inserter(slow),
                   [](const auto& sample) { return sample.second; });
  }
  return slow;
}

std::size_t longest_by_chance(std::span<const double> values) {
  const std::vector<std::size_t> slow = slow_samples(values);
  std::size_t equal = 0;
  std::size_t turning = 0;
  for (const std::size_t i : slow) {
    const double before = values[i] - values[i - 1];
    const double after = values[i + 1] - values[i];
    equal += after == 0 ? 1U : 0U;
    turning += (after > 0 && before < 0) || (after < 0 && before > 0) ? 1U : 0U;
  }
  const double all = static_cast<double>(std::max<std::size_t>(slow.size(), 1));
  const double equal_share = static_cast<double>(equal) / all;
  const double turning_share = static_cast<double>(turning) / all;
  if (turning_share >= 0.4 && equal_share <= 0.05) {
    return kLongestOfFine;
  }
  return turning_share >= 0.25 && equal_share <= 0.3 ? kLongestOfCoarse : 0;
}

double largest_rise(std::span<const double> values, const Stretch& stretch, double sign) {
  double lowest = sign * values[stretch.first];
  double most = 0;
  for (const double value : values.subspan(stretch.first, stretch.count)) {
    lowest = std::min(lowest, sign * value);
    most = std::max(most, sign * value - lowest);
  }
  return most;
}

/// The largest excursion to the side of `sign` that comes back as far.
double hump(std::span<const double> values, const Stretch& stretch, double sign) {
  std::vector<double> before;
  double lowest = sign * values[stretch.first];
  for (const double value : values.subspan(stretch.first, stretch.count)) {
    lowest = std::min(lowest, sign * value);
    before.push_back(lowest);
  }
  double most = 0;
  lowest = sign * values[stretch.end() - 1];
  for (std::size_t i = stretch.end(); i-- > stretch.first;) {
    const double value = sign * values[i];
    lowest = std::min(lowest, value);
    most = std::max(most, value - std::max(lowest, before[i - stretch.first]));
  }
  return most;
}

}  // namespace

Sensor sensor_of(std::span<const double> values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return {*lowest, *highest, noise_sigma(values), resolution(values), longest_by_chance(values)};
}

std::size_t hold_of(std::span<const double> values) {
  constexpr std::size_t kLeastValues = 20;
  constexpr double kMost = 0.8;
  constexpr double kFine = 2;  // least steps
  std::vector<Stretch> rows = still_stretches(values, 1);
  if (rows.size() < kLeastValues + 2) {
    return 1;
  }
  // Of the first and the last a part may be missing.
  rows.pop_back();
  rows.erase(rows.begin());
  const double least = kFine * resolution(values);
  std::vector<double> counts;
  double coarse = 0;
  for (const Stretch& row : rows) {
    counts.push_back(static_cast<double>(row.count));
    coarse += std::abs(values[row.first] - values[row.first - 1]) > least ? 0 : 1;
  }
  const double hold = quantile(counts, 0.5);
  const double alike = static_cast<double>(std::ranges::count_if(
      counts, [&](double count) { return count > 1 && std::abs(count - hold) <= 1; }));
  const auto all = static_cast<double>(rows.size());
  return hold > 1 && alike >= kMost * all && 2 * coarse <= all ? static_cast<std::size_t>(hold) : 1;
}

std::vector<Stretch> still_stretches(std::span<const double> values, std::size_t least) {
  std::vector<Stretch> stretches;
  std::size_t first = 0;
  for (std::size_t i = 1; i <= values.size(); ++i) {
    if (i < values.size() && values[i] == values[first]) {
      continue;
    }
    if (i - first >= least) {
      stretches.push_back({first, i - first});
    }
    first = i;
  }
  return stretches;
}

double rise_in(std::span<const double> values, const Stretch& stretch) {
  return largest_rise(values, stretch, 1);
}

double fall_in(std::span<const double> values, const Stretch& stretch) {
  return largest_rise(values, stretch, -1);
}

double swing_in(std::span<const double> values, const Stretch& stretch) {
  return std::max(hump(values, stretch, 1), hump(values, stretch, -1));
}

}  // namespace host_sim::recording
