#include "host_sim/statistics/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <tuple>

namespace host_sim::statistics {
namespace {

constexpr double kSqrt2 = std::numbers::sqrt2;
const double kHalfLogTwoPi = 0.5 * std::log(2 * std::numbers::pi);

/// From here on erfc loses digits or underflows, and the continued fraction is short.
constexpr double kFarTail = 10;

/// Laplace's continued fraction z + 1/(z + 2/(z + 3/(z + ...))), Abramowitz and Stegun 26.2.14.
double far_hazard(double z) {
  constexpr int kTerms = 30;
  double fraction = z;
  for (int k = kTerms; k >= 1; --k) {
    fraction = z + k / fraction;
  }
  return fraction;
}

}  // namespace

double student95(double degrees_of_freedom) {
  constexpr double kUpper = 0.975;
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), kUpper);
}

double outlier_limit(std::vector<double> magnitudes) {
  constexpr double kOutlier = 4;
  constexpr double kSdPerMedian = 1.4826;
  const auto middle = magnitudes.begin() + std::ssize(magnitudes) / 2;
  std::ranges::nth_element(magnitudes, middle);
  return kOutlier * kSdPerMedian * *middle;
}

double log_normal_density(double z) {
  return -0.5 * z * z - kHalfLogTwoPi;
}

double log_normal_survival(double z) {
  if (z >= kFarTail) {
    return log_normal_density(z) - std::log(far_hazard(z));
  }
  if (z < 0) {
    return std::log1p(-0.5 * std::erfc(-z / kSqrt2));
  }
  return std::log(0.5 * std::erfc(z / kSqrt2));
}

double normal_hazard(double z) {
  if (z >= kFarTail) {
    return far_hazard(z);
  }
  return 2 * std::exp(log_normal_density(z)) / std::erfc(z / kSqrt2);
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Deviate of the normal distribution below which `p` lie.
double normal_quantile(double p) {
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  if (p <= 0) {
    return -kInfinity;
  }
  return p >= 1 ? kInfinity : -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p, Policy());
}

/// (x / alpha)^beta
double cumulative_hazard(const Distribution& weibull, double x) {
  return std::pow(x / weibull.first, weibull.second);
}

double log_weibull_density(const Distribution& weibull, double x) {
  return std::log(weibull.second / weibull.first) +
         (weibull.second - 1) * std::log(x / weibull.first) - cumulative_hazard(weibull, x);
}

double deviate(const Distribution& distribution, double x) {
  const double value = distribution.family == Family::lognormal ? std::log(x) : x;
  return (value - distribution.first) / distribution.second;
}

bool outside(const Distribution& distribution, double x) {
  return distribution.family != Family::normal && x <= 0;
}

}  // namespace

double Distribution::cdf(double x) const {
  if (outside(*this, x)) {
    return 0;
  }
  if (family == Family::weibull) {
    return -std::expm1(-cumulative_hazard(*this, x));
  }
  return 0.5 * std::erfc(-deviate(*this, x) / std::numbers::sqrt2);
}

double Distribution::log_density(double x) const {
  if (outside(*this, x)) {
    return -kInfinity;
  }
  if (family == Family::weibull) {
    return log_weibull_density(*this, x);
  }
  const double density = log_normal_density(deviate(*this, x)) - std::log(second);
  return family == Family::lognormal ? density - std::log(x) : density;
}

double Distribution::log_survival(double x) const {
  if (outside(*this, x)) {
    return 0;
  }
  if (family == Family::weibull) {
    return -cumulative_hazard(*this, x);
  }
  return log_normal_survival(deviate(*this, x));
}

double Distribution::quantile(double p) const {
  if (family == Family::weibull) {
    return first * std::pow(-std::log1p(-p), 1 / second);
  }
  const double value = first + second * normal_quantile(p);
  return family == Family::lognormal ? std::exp(value) : value;
}

double Distribution::mean() const {
  switch (family) {
    case Family::lognormal:
      return std::exp(first + 0.5 * second * second);
    case Family::weibull:
      return first * std::tgamma(1 + 1 / second);
    case Family::normal:
      break;
  }
  return first;
}

namespace {

double log_probability(const Distribution& distribution, const Observation& seen) {
  if (!seen.failed) {
    return distribution.log_survival(seen.value);
  }
  if (!seen.from) {
    return distribution.log_density(seen.value);
  }
  // The share that breaks in between of those alive before.
  const double before = *seen.from > 0 ? distribution.log_survival(*seen.from) : 0;
  return before + std::log(-std::expm1(distribution.log_survival(seen.value) - before));
}

}  // namespace

double log_likelihood(const Distribution& distribution, std::span<const Observation> sample) {
  double sum = 0;
  for (const Observation& seen : sample) {
    sum += log_probability(distribution, seen);
  }
  return sum;
}

bool rises_failures_first(const Observation& left, const Observation& right) {
  const auto rank = [](const Observation& seen) {
    return std::tuple(seen.value, !seen.failed, seen.failed && !seen.trimmed);
  };
  return rank(left) < rank(right);
}

void KaplanMeier::assign(std::span<const Observation> sample) {
  sorted_.assign(sample.begin(), sample.end());
  std::sort(sorted_.begin(), sorted_.end(), rises_failures_first);
  assign_in_order(sorted_);
}

void KaplanMeier::assign_in_order(std::span<const Observation> sample) {
  steps_.clear();
  size_ = static_cast<double>(sample.size());
  last_ = sample.empty() ? 0 : sample.back().value;
  double at_risk = size_;
  double survival = 1;
  dropped_ = 0;
  for (const Observation& seen : sample) {
    if (seen.failed && seen.trimmed) {
      survival *= (at_risk - 1) / at_risk;
      dropped_ = 1 - survival;
    } else if (seen.failed) {
      const double before = 1 - survival;
      survival *= (at_risk - 1) / at_risk;
      if (!steps_.empty() && steps_.back().value == seen.value) {
        steps_.back().after = 1 - survival;
      } else {
        steps_.push_back({.value = seen.value, .before = before, .after = 1 - survival});
      }
    }
    --at_risk;
  }
}

}  // namespace host_sim::statistics
