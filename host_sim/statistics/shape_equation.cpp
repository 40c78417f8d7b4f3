#include "host_sim/statistics/shape_equation.hpp"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace host_sim::statistics {
namespace {

/// Mean and variance of the values, weighted with exp(shape * value).
struct WeightedMoments {
  double mean;
  double variance;
};

WeightedMoments weighted_moments(const CentredSample& sample, double shape) {
  double weights = 0;
  double first = 0;
  double second = 0;
  for (const double value : sample.all()) {
    const double weight = std::exp(shape * value);
    weights += weight;
    first += weight * value;
    second += weight * value * value;
  }
  const double mean = first / weights;
  return {.mean = mean, .variance = second / weights - mean * mean};
}

/// Eq. (16) over the number of failures, in the spread x = 1 / beta where it is nearly straight:
/// it falls with a slope of -1 or steeper, from above zero at x = 0.
class SpreadEquation {
 public:
  explicit SpreadEquation(std::span<const CentredSample> samples) : samples_(samples) {
    for (const CentredSample& sample : samples) {
      failures_ += static_cast<double>(sample.failures());
    }
  }

  std::pair<double, double> operator()(double spread) const {
    double value = -spread;
    double slope = -1;
    for (const CentredSample& sample : samples_) {
      if (sample.failures() == 0) {
        continue;
      }
      const auto moments = weighted_moments(sample, 1 / spread);
      value += share(sample) * (moments.mean - sample.failed_mean());
      slope -= share(sample) * moments.variance / (spread * spread);
    }
    return {value, slope};
  }

  /// The root is not above: a weighted mean is not above the largest value, which is zero.
  [[nodiscard]] double highest() const {
    double sum = 0;
    for (const CentredSample& sample : samples_) {
      sum -= share(sample) * sample.failed_mean();
    }
    return sum;
  }

  /// The spread by moments of the failures.
  [[nodiscard]] double guess() const {
    double squares = 0;
    for (const CentredSample& sample : samples_) {
      squares += share(sample) * sample.failed_deviation() * sample.failed_deviation();
    }
    return std::sqrt(6 * squares) / std::numbers::pi;
  }

 private:
  [[nodiscard]] double share(const CentredSample& sample) const {
    return static_cast<double>(sample.failures()) / failures_;
  }

  std::span<const CentredSample> samples_;
  double failures_ = 0;
};

}  // namespace

FitProblem shape_problem(std::span<const CentredSample> samples) {
  std::size_t failures = 0;
  bool spread = false;
  for (const CentredSample& sample : samples) {
    failures += sample.failures();
    spread = spread || !sample.without_spread();
  }
  if (failures < 2) {
    return FitProblem::too_few_failures;
  }
  return spread ? FitProblem::none : FitProblem::no_spread;
}

double solve_shape(std::span<const CentredSample> samples) {
  constexpr int kDigits = 32;  // of the last step; after it all are right
  constexpr std::uintmax_t kIterations = 200;
  const SpreadEquation equation(samples);
  const double highest = equation.highest();
  double guess = equation.guess();
  if (guess <= 0 || guess > highest) {
    guess = highest / 2;
  }
  std::uintmax_t iterations = kIterations;
  const double spread = boost::math::tools::newton_raphson_iterate(equation, guess, 0.0, highest,
                                                                   kDigits, iterations);
  const bool found = iterations < kIterations && spread > 0 && std::isfinite(1 / spread);
  return found ? 1 / spread : 0;
}

double log_scale(const CentredSample& sample, double shape) {
  if (sample.failures() == 0) {
    return std::numeric_limits<double>::infinity();
  }
  double weights = 0;
  for (const double value : sample.all()) {
    weights += std::exp(shape * value);
  }
  return sample.largest() + std::log(weights / static_cast<double>(sample.failures())) / shape;
}

double shape_log_likelihood(std::span<const CentredSample> samples, double shape) {
  double sum = 0;
  for (const CentredSample& sample : samples) {
    if (sample.failures() == 0) {
      continue;
    }
    // The cumulative hazards of a sample at its best scale add up to its failures.
    const double mean = sample.largest() + sample.failed_mean();
    sum += static_cast<double>(sample.failures()) *
           (std::log(shape) + shape * (mean - log_scale(sample, shape)) - mean - 1);
  }
  return sum;
}

}  // namespace host_sim::statistics
