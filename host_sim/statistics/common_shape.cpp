#include "host_sim/statistics/common_shape.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

#include "host_sim/statistics/shape_equation.hpp"

namespace host_sim::statistics {
namespace {

std::vector<CentredSample> logarithms(std::span<const Sample> samples) {
  std::vector<CentredSample> result;
  for (const Sample& sample : samples) {
    result.emplace_back(Family::weibull, sample);
  }
  return result;
}

/// How far 2 log L is below its maximum at exp(`log_shape`), less `allowed`.
class ShapeDrop {
 public:
  ShapeDrop(std::span<const CentredSample> samples, double highest, double allowed)
      : samples_(samples), highest_(highest), allowed_(allowed) {}
  double operator()(double log_shape) const {
    return 2 * (highest_ - shape_log_likelihood(samples_, std::exp(log_shape))) - allowed_;
  }

 private:
  std::span<const CentredSample> samples_;
  double highest_;
  double allowed_;
};

/// Where the likelihood has dropped as far as allowed, going up (+1) or down (-1) from the
/// estimate.
double end_of_interval(const ShapeDrop& drop, double log_shape, double direction) {
  constexpr int kDigits = 40;
  double inside = log_shape;
  double step = 0.1 * direction;
  double outside = inside + step;
  while (drop(outside) < 0) {
    inside = outside;
    step *= 2;
    outside += step;
  }
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      drop, std::min(inside, outside), std::max(inside, outside),
      boost::math::tools::eps_tolerance<double>(kDigits), iterations);
  return std::exp((bracket.first + bracket.second) / 2);
}

}  // namespace

CommonShapeFit fit_common_shape(std::span<const Sample> samples) {
  const std::vector<CentredSample> logs = logarithms(samples);
  CommonShapeFit result;
  result.problem = shape_problem(logs);
  if (result.problem != FitProblem::none) {
    return result;
  }
  result.shape = solve_shape(logs);
  if (result.shape == 0) {
    result.problem = FitProblem::not_converged;
    return result;
  }
  for (const CentredSample& sample : logs) {
    result.scales.push_back(std::exp(log_scale(sample, result.shape)));
  }
  result.log_likelihood = shape_log_likelihood(logs, result.shape);
  return result;
}

Interval common_shape_interval(std::span<const Sample> samples, const CommonShapeFit& fit,
                               double confidence) {
  // Chi-square of one degree of freedom.
  const double allowed = 2 * boost::math::gamma_p_inv(0.5, confidence);
  const std::vector<CentredSample> logs = logarithms(samples);
  const ShapeDrop drop(logs, fit.log_likelihood, allowed);
  const double log_shape = std::log(fit.shape);
  return {.low = end_of_interval(drop, log_shape, -1), .high = end_of_interval(drop, log_shape, 1)};
}

}  // namespace host_sim::statistics
