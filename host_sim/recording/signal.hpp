#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace host_sim::recording {

/// Samples in a row.
struct Stretch {
  std::size_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] std::size_t end() const { return first + count; }
  friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// The stretches of samples whose mark is `wanted`, in order, leaving out those under `least`.
std::vector<Stretch> stretches_of(const std::vector<bool>& marks, bool wanted,
                                  std::size_t least = 1);

/// The integral of a rate over time by trapezoids, from 0 at the first sample on.
std::vector<double> integral(std::span<const double> time_s, std::span<const double> rate);

/// Value and slope at one sample of the polynomial that fits the samples around it best.
struct LocalFit {
  double value = 0;
  double slope_1_s = 0;
};

/// By a cubic over `reach_s` to each side, a quadratic where the end of the piece cuts that off
/// (Savitzky and Golay, 1964).
/// @return false where those are fewer than seven samples, and `fit` is left as it is
bool fit_locally(std::span<const double> time_s, std::span<const double> values,
                 const Stretch& piece, std::size_t i, double reach_s, LocalFit& fit);

/// The values of those fits; where there is none, and outside of the pieces, the values as they
/// are.
std::vector<double> smoothed(std::span<const double> time_s, std::span<const double> values,
                             std::span<const Stretch> pieces, double reach_s);

/// Means over as many samples to each side as lie within `reach_s` of the sample and are in its
/// piece, the same number on both sides: what is linear stays. Outside of the pieces the values as
/// they are.
std::vector<double> moving_mean(std::span<const double> time_s, std::span<const double> values,
                                std::span<const Stretch> pieces, double reach_s);

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
