#include "host_sim/statistics/fit.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/location_scale.hpp"

namespace host_sim::statistics {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

}  // namespace

void CentredSample::assign(Family family, std::span<const Observation> sample) {
  copy(family, sample);
  centre();
  measure_failures();
}

void CentredSample::copy(Family family, std::span<const Observation> sample) {
  const auto of = [family](double life) {
    return family == Family::normal ? life : std::log(life);
  };
  values_.clear();
  between_.clear();
  for (const Observation& seen : sample) {
    if (seen.exact()) {
      values_.push_back(of(seen.value));
    } else if (seen.failed) {
      between_.push_back(
          {.low = *seen.from > 0 ? of(*seen.from) : -kEndless, .high = of(seen.value)});
    }
  }
  exact_ = values_.size();
  for (auto seen = sample.rbegin(); seen != sample.rend(); ++seen) {
    if (!seen->failed) {
      values_.push_back(of(seen->value));
    }
  }
}

void CentredSample::centre() {
  largest_ = values_.empty() && between_.empty() ? 0 : -kEndless;
  for (const double value : values_) {
    largest_ = std::max(largest_, value);
  }
  for (const Ends& ends : between_) {
    largest_ = std::max(largest_, ends.high);
  }
  latest_start_ = -kEndless;
  earliest_end_ = kEndless;
  for (double& value : values_) {
    value -= largest_;
    latest_start_ = std::max(latest_start_, value);
  }
  for (const double value : failed()) {
    earliest_end_ = std::min(earliest_end_, value);
  }
  for (Ends& ends : between_) {
    ends.low -= largest_;
    ends.high -= largest_;
    latest_start_ = std::max(latest_start_, ends.low);
    earliest_end_ = std::min(earliest_end_, ends.high);
  }
}

namespace {

/// One value that stands for what lies between.
double middle(const CentredSample::Ends& ends) {
  return std::isinf(ends.low) ? ends.high : (ends.low + ends.high) / 2;
}

}  // namespace

void CentredSample::measure_failures() {
  failed_mean_ = 0;
  failed_deviation_ = 0;
  if (failures() == 0) {
    return;
  }
  const auto count = static_cast<double>(failures());
  for (const double value : failed()) {
    failed_mean_ += value / count;
  }
  for (const Ends& ends : between_) {
    failed_mean_ += middle(ends) / count;
  }
  double squares = 0;
  const auto add = [&](double value) {
    squares += (value - failed_mean_) * (value - failed_mean_);
  };
  std::ranges::for_each(failed(), add);
  for (const Ends& ends : between_) {
    add(middle(ends));
  }
  failed_deviation_ = std::sqrt(squares / count);
}

double CentredSample::spread() const {
  const auto failures_of_all = static_cast<double>(failures());
  double squares = failed_deviation_ * failed_deviation_ * failures_of_all;
  double count = failures_of_all;
  for (const double value : suspended()) {
    if (value > failed_mean_) {
      squares += (value - failed_mean_) * (value - failed_mean_);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

bool CentredSample::bounded() const {
  return failures() > 0 && latest_start_ > -kEndless;
}

FitProblem CentredSample::problem() const {
  if (failures() < 2) {
    return FitProblem::too_few_failures;
  }
  return without_spread() ? FitProblem::no_spread : FitProblem::none;
}

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

namespace {

bool lives_known(std::span<const CentredSample> samples) {
  return std::ranges::all_of(samples,
                             [](const CentredSample& sample) { return sample.between().empty(); });
}

double solve_shape_between(std::span<const CentredSample> samples) {
  std::vector<CentredSample> bounded;
  std::ranges::copy_if(samples, std::back_inserter(bounded), &CentredSample::bounded);
  const LocationScaleFit fit = fit_location_scale(bounded, Standard::smallest_extreme);
  const double shape = 1 / fit.scale;
  return fit.converged && std::isfinite(shape) ? shape : 0;
}

}  // namespace

double solve_shape(std::span<const CentredSample> samples) {
  if (!lives_known(samples)) {
    return solve_shape_between(samples);
  }
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
  if (!sample.bounded()) {
    return sample.failures() == 0 ? kEndless : -kEndless;
  }
  if (!sample.between().empty()) {
    const std::span<const CentredSample> alone(&sample, 1);
    return sample.largest() +
           fit_locations(alone, Standard::smallest_extreme, 1 / shape).location.front();
  }
  double weights = 0;
  for (const double value : sample.all()) {
    weights += std::exp(shape * value);
  }
  return sample.largest() + std::log(weights / static_cast<double>(sample.failures())) / shape;
}

namespace {

/// Densities are per life, not per logarithm of it.
double log_jacobian(const CentredSample& logs) {
  double sum = 0;
  for (const double value : logs.failed()) {
    sum -= logs.largest() + value;
  }
  return sum;
}

}  // namespace

double shape_log_likelihood(std::span<const CentredSample> samples, double shape) {
  double sum = 0;
  for (const CentredSample& sample : samples) {
    if (!sample.bounded()) {
      continue;
    }
    if (!sample.between().empty()) {
      const std::span<const CentredSample> alone(&sample, 1);
      sum += log_jacobian(sample) +
             fit_locations(alone, Standard::smallest_extreme, 1 / shape).log_likelihood;
      continue;
    }
    // The cumulative hazards of a sample at its best scale add up to its failures.
    const double mean = sample.largest() + sample.failed_mean();
    sum += static_cast<double>(sample.failures()) *
           (std::log(shape) + shape * (mean - log_scale(sample, shape)) - mean - 1);
  }
  return sum;
}

namespace {

/// Normal distribution by maximum likelihood; the suspended count with their tail.
/// @pre sample.problem() is none
Fit fit_normal(const CentredSample& sample) {
  const LocationScaleFit fit =
      fit_location_scale(std::span<const CentredSample>(&sample, 1), Standard::normal);
  if (!fit.converged) {
    return {.distribution = {}, .problem = FitProblem::not_converged};
  }
  return {.distribution = {.family = Family::normal,
                           .first = sample.largest() + fit.location.front(),
                           .second = fit.scale},
          .log_likelihood = fit.log_likelihood};
}

Fit fit_weibull(const CentredSample& logs) {
  const std::span<const CentredSample> samples(&logs, 1);
  const double shape = solve_shape(samples);
  if (shape == 0) {
    return {.distribution = {}, .problem = FitProblem::not_converged};
  }
  return {.distribution = {.family = Family::weibull,
                           .first = std::exp(log_scale(logs, shape)),
                           .second = shape},
          .log_likelihood = shape_log_likelihood(samples, shape)};
}

}  // namespace

Fit fit(Family family, const CentredSample& sample) {
  Fit result{.distribution = {}, .problem = sample.problem()};
  if (result.problem == FitProblem::none) {
    result = family == Family::weibull ? fit_weibull(sample) : fit_normal(sample);
  }
  result.distribution.family = family;
  if (family == Family::lognormal) {
    result.log_likelihood += log_jacobian(sample);
  }
  return result;
}

Fit fit(Family family, std::span<const Observation> sample) {
  return fit(family, CentredSample(family, sample));
}

}  // namespace host_sim::statistics
