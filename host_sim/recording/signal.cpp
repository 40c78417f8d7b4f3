#include "host_sim/recording/signal.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstddef>

namespace host_sim::recording {

std::vector<Stretch> stretches_of(const std::vector<bool>& marks, bool wanted, std::size_t least) {
  std::vector<Stretch> stretches;
  std::size_t first = 0;
  while (first < marks.size()) {
    std::size_t end = first;
    while (end < marks.size() && marks[end] == wanted) {
      ++end;
    }
    if (end > first && end - first >= least) {
      stretches.push_back({first, end - first});
    }
    first = end + (end == first ? 1 : 0);
  }
  return stretches;
}

std::vector<double> integral(std::span<const double> time_s, std::span<const double> rate) {
  std::vector<double> sums(rate.size());
  for (std::size_t i = 1; i < rate.size(); ++i) {
    sums[i] = sums[i - 1] + (rate[i] + rate[i - 1]) / 2 * (time_s[i] - time_s[i - 1]);
  }
  return sums;
}

namespace {

constexpr std::size_t kLeastToFit = 7;
constexpr double kRounding = 1e-9;  ///< samples at the very end of the reach count

struct Window {
  std::size_t first = 0, last = 0;
  bool whole = true;  ///< not cut by the end of a piece

  [[nodiscard]] std::size_t size() const { return last - first + 1; }
};

Window window_of(std::span<const double> time_s, const Stretch& piece, std::size_t i,
                 double reach_s) {
  const double most_s = reach_s * (1 + kRounding);
  Window window{i, i};
  while (window.first > piece.first && time_s[i] - time_s[window.first - 1] <= most_s) {
    --window.first;
  }
  while (window.last + 1 < piece.end() && time_s[window.last + 1] - time_s[i] <= most_s) {
    ++window.last;
  }
  window.whole = window.first > piece.first && window.last + 1 < piece.end();
  return window;
}

template <int kDegree>
LocalFit polynomial(std::span<const double> time_s, std::span<const double> values,
                    const Window& window, std::size_t i, double reach_s) {
  Eigen::Matrix<double, kDegree + 1, kDegree + 1> squares;
  Eigen::Matrix<double, kDegree + 1, 1> products;
  squares.setZero();
  products.setZero();
  for (std::size_t k = window.first; k <= window.last; ++k) {
    Eigen::Matrix<double, kDegree + 1, 1> powers;
    powers(0) = 1;
    for (int power = 1; power <= kDegree; ++power) {
      powers(power) = powers(power - 1) * (time_s[k] - time_s[i]) / reach_s;
    }
    squares += powers * powers.transpose();
    products += powers * (values[k] - values[i]);
  }
  const Eigen::Matrix<double, kDegree + 1, 1> fit = squares.ldlt().solve(products);
  return {values[i] + fit(0), fit(1) / reach_s};
}

}  // namespace

bool fit_locally(std::span<const double> time_s, std::span<const double> values,
                 const Stretch& piece, std::size_t i, double reach_s, LocalFit& fit) {
  const Window window = window_of(time_s, piece, i, reach_s);
  if (window.size() < kLeastToFit) {
    return false;
  }
  fit = window.whole ? polynomial<3>(time_s, values, window, i, reach_s)
                     : polynomial<2>(time_s, values, window, i, reach_s);
  return true;
}

bool fit_wave_locally(std::span<const double> time_s, std::span<const double> values,
                      const Stretch& piece, std::size_t i, double reach_s, LocalFit& fit) {
  constexpr std::size_t kLeastOfWave = 9;
  const Window window = window_of(time_s, piece, i, reach_s);
  if (!window.whole || window.size() < kLeastOfWave) {
    return fit_locally(time_s, values, piece, i, reach_s, fit);
  }
  fit = polynomial<5>(time_s, values, window, i, reach_s);
  return true;
}

std::vector<double> smoothed(std::span<const double> time_s, std::span<const double> values,
                             std::span<const Stretch> pieces, double reach_s) {
  std::vector<double> smooth(values.begin(), values.end());
  for (const Stretch& piece : pieces) {
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      LocalFit fit{.value = values[i]};
      fit_locally(time_s, values, piece, i, reach_s, fit);
      smooth[i] = fit.value;
    }
  }
  return smooth;
}

}  // namespace host_sim::recording
