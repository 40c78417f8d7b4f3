#pragma once

#include <span>
#include <vector>

#include "host_sim/recording/stretch.hpp"

namespace host_sim::recording {

/// d ln T / dt by differences over two samples to each side, fewer at the ends of a piece: each
/// piece, of at least two samples, stands for itself. Zero outside of the pieces.
/// @param tension_N above 0 within the pieces
std::vector<double> log_rate_1_s(std::span<const double> time_s, std::span<const double> tension_N,
                                 std::span<const Stretch> pieces);

/// The same of a tension without jumps: the slope of fit_locally() over kSmooth_s to each side.
/// Where those are too few samples it is log_rate_1_s().
std::vector<double> smooth_log_rate_1_s(std::span<const double> time_s,
                                        std::span<const double> tension_N,
                                        std::span<const Stretch> pieces);

inline constexpr double kSmooth_s = 0.05;

}  // namespace host_sim::recording
