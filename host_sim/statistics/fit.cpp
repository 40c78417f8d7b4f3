#include "host_sim/statistics/fit.hpp"

#include <cmath>

#include "host_sim/statistics/centred_sample.hpp"
#include "host_sim/statistics/normal_fit.hpp"
#include "host_sim/statistics/shape_equation.hpp"

namespace host_sim::statistics {
namespace {

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
