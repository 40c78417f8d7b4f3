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

/// The same by a quintic where the end of the piece is far enough: a wave of which a half lies
/// within the reach to each side is 2.5 % smaller, and by a cubic 26 %.
bool fit_wave_locally(std::span<const double> time_s, std::span<const double> values,
                      const Stretch& piece, std::size_t i, double reach_s, LocalFit& fit);

/// The values of the first of those fits; where there is none, and outside of the pieces, the
/// values as they are.
std::vector<double> smoothed(std::span<const double> time_s, std::span<const double> values,
                             std::span<const Stretch> pieces, double reach_s);

}  // namespace host_sim::recording
