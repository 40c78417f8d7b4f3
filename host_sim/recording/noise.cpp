#include "host_sim/recording/noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

}  // namespace host_sim::recording
