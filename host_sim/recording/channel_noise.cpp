#include "host_sim/recording/channel_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace host_sim::recording {
namespace {

constexpr std::size_t kRun = 4;
constexpr double kEvenStep = 1.5;  ///< a longer one than this many of the one before is a gap
constexpr std::size_t kLeastRuns = 64;
constexpr std::size_t kMostBins = 12;
constexpr std::size_t kLeastInBin = 32;
/// Median of the square of a standard normal.
constexpr double kMedianSquare = 0.45493642311957283;
/// Of the squares of the coefficients of a third difference, 1 3 3 1.
constexpr double kThirdSquares = 20;
/// To each side of a sample, for the tension that its noise goes with.
constexpr std::size_t kLevel = 8;
/// Of ln T: what is noisier is no measurement.
constexpr double kMostVariance = 1;

struct Run {
  double square_N2;    ///< squared tension, the mean of the run
  double variance_N2;  ///< squared third difference over what white noise of variance 1 has
};

bool is_run(const Covariates& covariates, std::size_t end) {
  const std::vector<double>& time_s = covariates.time_s;
  const double step_s = time_s[end - kRun + 2] - time_s[end - kRun + 1];
  for (std::size_t i = end - kRun + 2; i <= end; ++i) {
    const double here_s = time_s[i] - time_s[i - 1];
    if (covariates.direction[i] != covariates.direction[i - 1] || here_s > kEvenStep * step_s ||
        step_s > kEvenStep * here_s) {
      return false;
    }
  }
  return true;
}

void add_runs(const Covariates& covariates, const std::vector<double>& tension_N,
              std::vector<Run>& runs) {
  for (std::size_t i = kRun - 1; i < tension_N.size(); ++i) {
    if (!is_run(covariates, i)) {
      continue;
    }
    const double third_N =
        tension_N[i] - tension_N[i - 3] - 3 * (tension_N[i - 1] - tension_N[i - 2]);
    const double mean_N =
        (tension_N[i] + tension_N[i - 1] + tension_N[i - 2] + tension_N[i - 3]) / kRun;
    runs.push_back({mean_N * mean_N, third_N * third_N / kThirdSquares});
  }
}

/// Variance against squared tension, a straight line through medians of bins; each counts by its
/// own relative scatter.
ChannelNoise line_through(std::vector<Run> runs) {
  std::ranges::sort(runs, {}, &Run::square_N2);
  const std::size_t bins = std::clamp(runs.size() / kLeastInBin, std::size_t{1}, kMostBins);
  std::vector<Run> medians;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const auto first = runs.begin() + static_cast<std::ptrdiff_t>(bin * runs.size() / bins);
    const auto end = runs.begin() + static_cast<std::ptrdiff_t>((bin + 1) * runs.size() / bins);
    const auto middle = first + (end - first) / 2;
    const double square_N2 = middle->square_N2;
    std::ranges::nth_element(first, middle, end, {}, &Run::variance_N2);
    medians.push_back({square_N2, middle->variance_N2 / kMedianSquare});
  }
  double one = 0;
  double x = 0;
  double xx = 0;
  double y = 0;
  double xy = 0;
  double largest_N2 = 0;
  for (const Run& median : medians) {
    largest_N2 = std::max(largest_N2, median.variance_N2);
  }
  if (largest_N2 == 0) {
    return {};
  }
  for (const Run& median : medians) {
    constexpr double kLeastOfLargest = 1e-3;
    const double scale_N2 = std::max(median.variance_N2, kLeastOfLargest * largest_N2);
    const double weight = 1 / (scale_N2 * scale_N2);
    one += weight;
    x += weight * median.square_N2;
    xx += weight * median.square_N2 * median.square_N2;
    y += weight * median.variance_N2;
    xy += weight * median.square_N2 * median.variance_N2;
  }
  const double determinant = one * xx - x * x;
  double at_zero_N2 = y / one;
  double slope = 0;
  constexpr double kApart = 1e-6;
  if (determinant > kApart * one * xx) {
    at_zero_N2 = (xx * y - x * xy) / determinant;
    slope = (one * xy - x * y) / determinant;
    if (slope < 0) {
      slope = 0;
      at_zero_N2 = y / one;
    } else if (at_zero_N2 < 0) {
      at_zero_N2 = 0;
      slope = xy / xx;
    }
  }
  return {std::sqrt(at_zero_N2), std::sqrt(slope)};
}

/// Mean over the samples around each.
std::vector<double> levels_N(const std::vector<double>& tension_N) {
  std::vector<double> sums{0};
  for (const double value_N : tension_N) {
    sums.push_back(sums.back() + value_N);
  }
  std::vector<double> levels;
  for (std::size_t i = 0; i < tension_N.size(); ++i) {
    const std::size_t first = i - std::min(i, kLevel);
    const std::size_t end = std::min(i + kLevel + 1, tension_N.size());
    levels.push_back((sums[end] - sums[first]) / static_cast<double>(end - first));
  }
  return levels;
}

std::vector<double> log_variances(const Covariates& covariates,
                                  const std::vector<double>& tension_N) {
  const ChannelNoise noise = channel_noise(covariates, tension_N);
  std::vector<double> variances;
  for (const double level_N : levels_N(tension_N)) {
    variances.push_back(std::min(noise.variance_N2(level_N) / (level_N * level_N), kMostVariance));
  }
  return variances;
}

}  // namespace

ChannelNoise channel_noise(const Covariates& covariates, const std::vector<double>& tension_N) {
  std::vector<Run> runs;
  add_runs(covariates, tension_N, runs);
  return runs.size() < kLeastRuns ? ChannelNoise{} : line_through(std::move(runs));
}

void add_noise(Covariates& covariates) {
  covariates.input_noise = log_variances(covariates, covariates.tension_in_N());
  covariates.output_noise = log_variances(covariates, covariates.output_tension_N);
  const auto none = [](double variance) { return variance == 0; };
  if (std::ranges::all_of(covariates.input_noise, none) &&
      std::ranges::all_of(covariates.output_noise, none)) {
    covariates.input_noise.clear();
    covariates.output_noise.clear();
  }
}

}  // namespace host_sim::recording
