#include "host_sim/recording/integral.hpp"

#include <cstddef>

namespace host_sim::recording {

std::vector<double> integral(std::span<const double> time_s, std::span<const double> rate) {
  std::vector<double> sums(rate.size());
  for (std::size_t i = 1; i < rate.size(); ++i) {
    sums[i] = sums[i - 1] + (rate[i] + rate[i - 1]) / 2 * (time_s[i] - time_s[i - 1]);
  }
  return sums;
}

}  // namespace host_sim::recording
