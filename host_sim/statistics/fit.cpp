#include "host_sim/statistics/fit.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {

void CentredSample::assign(Family family, std::span<const Observation> sample) {
  copy(family, sample);
  largest_ = values_.empty() ? 0 : *std::max_element(values_.begin(), values_.end());
  for (double& value : values_) {
    value -= largest_;
  }
  measure_failures();
}

void CentredSample::copy(Family family, std::span<const Observation> sample) {
  values_.resize(sample.size());
  std::size_t front = 0;
  std::size_t back = sample.size();
  for (const Observation& seen : sample) {
    const double value = family == Family::normal ? seen.value : std::log(seen.value);
    values_[seen.failed ? front++ : --back] = value;
  }
  failures_ = front;
}

void CentredSample::measure_failures() {
  failed_mean_ = 0;
  failed_deviation_ = 0;
  if (failures_ == 0) {
    return;
  }
  const auto count = static_cast<double>(failures_);
  for (const double value : failed()) {
    failed_mean_ += value / count;
  }
  double squares = 0;
  for (const double value : failed()) {
    squares += (value - failed_mean_) * (value - failed_mean_);
  }
  failed_deviation_ = std::sqrt(squares / count);
}

FitProblem CentredSample::problem() const {
  if (failures_ < 2) {
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

namespace {

/// The parameters in which the likelihood is concave (Olsen 1978): the deviate of a value is
/// slope * (value - centre) / unit - offset.
struct Olsen {
  double offset;  ///< mean over standard deviation
  double slope;   ///< 1 over standard deviation
};

struct Derivatives {
  double offset = 0, slope = 0;
  double offset_offset = 0, offset_slope = 0, slope_slope = 0;

  /// Of a term of the log likelihood with derivatives `first` and `second` in its deviate.
  void add(double value, double first, double second) {
    offset -= first;
    slope += first * value;
    offset_offset += second;
    offset_slope -= second * value;
    slope_slope += second * value * value;
  }
};

/// Root mean square distance from the mean of the failures, of them and of the suspended beyond it.
double spread(const CentredSample& sample) {
  double squares = 0;
  double count = 0;
  const auto add = [&](double value) {
    squares += (value - sample.failed_mean()) * (value - sample.failed_mean());
    ++count;
  };
  for (const double value : sample.failed()) {
    add(value);
  }
  for (const double value : sample.suspended()) {
    if (value > sample.failed_mean()) {
      add(value);
    }
  }
  return std::sqrt(squares / count);
}

/// The likelihood in units of the spread of the sample.
class NormalLikelihood {
 public:
  explicit NormalLikelihood(const CentredSample& sample)
      : sample_(sample), failures_(static_cast<double>(sample.failures())), unit_(spread(sample)) {}

  [[nodiscard]] double operator()(Olsen at) const {
    double sum = failures_ * std::log(at.slope / unit_);
    for (const double value : sample_.failed()) {
      sum += log_normal_density(deviate(value, at));
    }
    for (const double value : sample_.suspended()) {
      sum += log_normal_survival(deviate(value, at));
    }
    return sum;
  }

  [[nodiscard]] Derivatives derivatives(Olsen at) const {
    Derivatives result;
    result.slope = failures_ / at.slope;
    result.slope_slope = -failures_ / (at.slope * at.slope);
    for (const double value : sample_.failed()) {
      result.add(scaled(value), -deviate(value, at), -1);
    }
    for (const double value : sample_.suspended()) {
      const double z = deviate(value, at);
      const double hazard = normal_hazard(z);
      result.add(scaled(value), -hazard, -hazard * (hazard - z));
    }
    return result;
  }

  [[nodiscard]] Distribution distribution(Olsen at) const {
    return {.family = Family::normal,
            .first = sample_.largest() + sample_.failed_mean() + unit_ * at.offset / at.slope,
            .second = unit_ / at.slope};
  }

 private:
  [[nodiscard]] double scaled(double value) const {
    return (value - sample_.failed_mean()) / unit_;
  }
  [[nodiscard]] double deviate(double value, Olsen at) const {
    return at.slope * scaled(value) - at.offset;
  }

  const CentredSample& sample_;
  double failures_;
  double unit_;
};

Olsen newton_step(const Derivatives& d) {
  const double determinant = d.offset_offset * d.slope_slope - d.offset_slope * d.offset_slope;
  return {.offset = (d.offset_slope * d.slope - d.slope_slope * d.offset) / determinant,
          .slope = (d.offset_slope * d.offset - d.offset_offset * d.slope) / determinant};
}

Olsen moved(Olsen from, Olsen step, double share) {
  return {.offset = from.offset + share * step.offset, .slope = from.slope + share * step.slope};
}

/// Part of the step that keeps the slope positive and does not lower the likelihood by more than
/// rounding does.
double usable_share(const NormalLikelihood& likelihood, Olsen from, Olsen step) {
  constexpr double kSmallest = 1e-9;
  constexpr double kRounding = 1e-13;
  const double before = likelihood(from);
  const double lowest = before - kRounding * (1 + std::abs(before));
  double share = 1;
  while (share > kSmallest) {
    const Olsen next = moved(from, step, share);
    if (next.slope > 0 && likelihood(next) >= lowest) {
      return share;
    }
    share /= 2;
  }
  return 0;
}

bool negligible(Olsen step, Olsen at) {
  constexpr double kTolerance = 1e-8;  // squared by the step itself
  return std::abs(step.offset) <= kTolerance * (1 + std::abs(at.offset)) &&
         std::abs(step.slope) <= kTolerance * at.slope;
}

/// Normal distribution by maximum likelihood; the suspended count with their tail.
/// @pre sample.problem() is none
Fit fit_normal(const CentredSample& sample) {
  constexpr int kIterations = 100;
  const NormalLikelihood likelihood(sample);
  Olsen at{.offset = 0, .slope = 1};
  for (int i = 0; i < kIterations; ++i) {
    const Olsen step = newton_step(likelihood.derivatives(at));
    if (negligible(step, at)) {
      at = moved(at, step, 1);
      return {.distribution = likelihood.distribution(at), .log_likelihood = likelihood(at)};
    }
    const double share = usable_share(likelihood, at, step);
    if (share == 0) {
      break;
    }
    at = moved(at, step, share);
  }
  return {.distribution = {}, .problem = FitProblem::not_converged};
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

/// Densities are per life, not per logarithm of it.
double log_jacobian(const CentredSample& logs) {
  return -static_cast<double>(logs.failures()) * (logs.largest() + logs.failed_mean());
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
