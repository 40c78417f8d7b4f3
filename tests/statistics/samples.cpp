#include "tests/statistics/samples.hpp"

#include <cmath>

namespace host_sim::statistics {

Sample failed(std::initializer_list<double> lives) {
  return with_suspended(lives, {});
}

Sample with_suspended(std::initializer_list<double> failed_lives,
                      std::initializer_list<double> suspended_lives) {
  Sample sample;
  for (const double life : failed_lives) {
    sample.push_back({.value = life, .failed = true});
  }
  for (const double life : suspended_lives) {
    sample.push_back({.value = life, .failed = false});
  }
  return sample;
}

Sample ideal_weibull(double scale, double shape, std::size_t count) {
  Sample sample;
  for (std::size_t i = 0; i < count; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    sample.push_back({.value = scale * std::pow(-std::log(1 - p), 1 / shape), .failed = true});
  }
  return sample;
}

}  // namespace host_sim::statistics
