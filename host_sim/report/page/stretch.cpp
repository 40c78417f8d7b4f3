#include "host_sim/report/page/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace host_sim {
namespace {

/// Where samples before a place are missing: the time between two is more than this many usual
/// ones.
constexpr double kGap = 3;

double usual_interval_s(const std::vector<double>& time_s) {
  std::vector<double> intervals_s(time_s.size());
  std::adjacent_difference(time_s.begin(), time_s.end(), intervals_s.begin());
  intervals_s.erase(intervals_s.begin());
  const auto middle = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
  std::nth_element(intervals_s.begin(), middle, intervals_s.end());
  return *middle;
}

}  // namespace

std::vector<std::size_t> gaps_in(const std::vector<double>& time_s) {
  std::vector<std::size_t> gaps;
  if (time_s.size() < 2) {
    return gaps;
  }
  const double most_s = kGap * usual_interval_s(time_s);
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] - time_s[i - 1] > most_s) {
      gaps.push_back(i);
    }
  }
  return gaps;
}

Stretch cycles_in(const std::vector<double>& input_N) {
  constexpr double kBand = 0.75;  // standard deviations
  constexpr std::size_t kCycles = 2;
  double count = 0, sum = 0, square = 0;
  for (const double value : input_N) {
    if (std::isfinite(value)) {
      count += 1;
      sum += value;
      square += value * value;
    }
  }
  const double mean = sum / count;
  const double band = kBand * std::sqrt(std::max(0.0, square / count - mean * mean));
  std::vector<std::size_t> rises;
  bool below = false;
  for (std::size_t i = 0; i < input_N.size(); ++i) {
    if (below && input_N[i] > mean + band) {
      rises.push_back(i);
    }
    below = input_N[i] < mean - band || (below && !(input_N[i] > mean + band));
  }
  if (rises.size() < 2) {
    return {0, input_N.size()};
  }
  const std::size_t cycles = std::min(kCycles, rises.size() - 1);
  const std::size_t first = (rises.size() - 1 - cycles) / 2;
  return {rises[first], rises[first + cycles] + 1};
}

std::vector<double> with_gaps(const std::vector<double>& values,
                              const std::vector<std::size_t>& gaps) {
  std::vector<double> all;
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (gap != gaps.end() && *gap == i) {
      all.push_back(std::numeric_limits<double>::quiet_NaN());
      ++gap;
    }
    all.push_back(values[i]);
  }
  return all;
}

std::vector<double> part_of(const std::vector<double>& values, const Stretch& stretch) {
  return {values.begin() + static_cast<std::ptrdiff_t>(stretch.first),
          values.begin() + static_cast<std::ptrdiff_t>(stretch.last)};
}

}  // namespace host_sim
