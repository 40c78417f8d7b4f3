#include "host_sim/recording/signal.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
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

std::vector<double> moving_mean(std::span<const double> time_s, std::span<const double> values,
                                std::span<const Stretch> pieces, double reach_s) {
  std::vector<double> means(values.begin(), values.end());
  std::vector<double> sums;
  for (const Stretch& piece : pieces) {
    sums.assign(1, 0);
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      sums.push_back(sums.back() + values[i]);
    }
    std::size_t reach = 0;  // samples to each side: from one sample to the next it hardly changes
    for (std::size_t k = 0; k < piece.count; ++k) {
      const std::size_t most = std::min(k, piece.count - 1 - k);
      const auto within = [&](std::size_t samples) {
        const std::size_t i = piece.first + k;
        return samples <= most && time_s[i + samples] - time_s[i - samples] <= 2 * reach_s;
      };
      while (within(reach + 1)) {
        ++reach;
      }
      while (reach > 0 && !within(reach)) {
        --reach;
      }
      means[piece.first + k] =
          (sums[k + reach + 1] - sums[k - reach]) / static_cast<double>(2 * reach + 1);
    }
  }
  return means;
}

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
