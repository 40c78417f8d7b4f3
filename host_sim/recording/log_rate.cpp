#include "host_sim/recording/log_rate.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::recording {

std::vector<double> log_rate_1_s(std::span<const double> time_s, std::span<const double> tension_N,
                                 std::span<const Stretch> pieces) {
  constexpr std::size_t kReach = 2;
  std::vector<double> rate_1_s(time_s.size());
  for (const Stretch& piece : pieces) {
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      const std::size_t from = i - std::min(kReach, i - piece.first);
      const std::size_t to = std::min(i + kReach, piece.end() - 1);
      rate_1_s[i] = std::log(tension_N[to] / tension_N[from]) / (time_s[to] - time_s[from]);
    }
  }
  return rate_1_s;
}

}  // namespace host_sim::recording
