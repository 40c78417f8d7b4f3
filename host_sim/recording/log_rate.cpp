#include "host_sim/recording/log_rate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host_sim/recording/smooth.hpp"

namespace host_sim::recording {
namespace {

constexpr std::size_t kReach = 2;

double difference_1_s(std::span<const double> time_s, std::span<const double> tension_N,
                      const Stretch& piece, std::size_t i) {
  const std::size_t first = i - std::min(kReach, i - piece.first);
  const std::size_t last = std::min(i + kReach, piece.end() - 1);
  return std::log(tension_N[last] / tension_N[first]) / (time_s[last] - time_s[first]);
}

}  // namespace

std::vector<double> log_rate_1_s(std::span<const double> time_s, std::span<const double> tension_N,
                                 std::span<const Stretch> pieces) {
  std::vector<double> rate_1_s(time_s.size());
  for (const Stretch& piece : pieces) {
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      rate_1_s[i] = difference_1_s(time_s, tension_N, piece, i);
    }
  }
  return rate_1_s;
}

std::vector<double> smooth_log_rate_1_s(std::span<const double> time_s,
                                        std::span<const double> tension_N,
                                        std::span<const Stretch> pieces) {
  std::vector<double> logs(time_s.size());
  std::vector<double> rate_1_s(time_s.size());
  for (const Stretch& piece : pieces) {
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      logs[i] = std::log(tension_N[i]);
    }
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      LocalFit fit;
      rate_1_s[i] = fit_locally(time_s, logs, piece, i, kSmooth_s, fit)
                        ? fit.slope_1_s
                        : difference_1_s(time_s, tension_N, piece, i);
    }
  }
  return rate_1_s;
}

}  // namespace host_sim::recording
