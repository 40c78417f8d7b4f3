#include "host_sim/statistics/common_shape.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "host_sim/statistics/bootstrap.hpp"
#include "host_sim/statistics/fit.hpp"

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
/// estimate; where lives are known only to lie between two ends it may never do so.
double end_of_interval(const ShapeDrop& drop, double log_shape, double direction) {
  constexpr int kDigits = 40;
  constexpr double kFurthest = 12;  // e^12 times the estimate
  double inside = log_shape;
  double step = 0.1 * direction;
  double outside = inside + step;
  while (drop(outside) < 0) {
    inside = outside;
    step *= 2;
    outside += step;
    if (std::abs(outside - log_shape) > kFurthest) {
      return direction > 0 ? std::numeric_limits<double>::infinity() : 0;
    }
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

namespace {

/// Samples with failures, and samples like them drawn from their common fit under the plan of
/// suspension of each.
class SameShapeSamples {
 public:
  struct Memory {
    Sample lives;
    std::vector<CentredSample> logs;
  };

  SameShapeSamples(std::span<const Sample> samples, const CommonShapeFit& common);

  /// Logarithms of the samples as measured.
  [[nodiscard]] std::span<const CentredSample> measured() const { return measured_; }
  /// Logarithms of samples as drawn, in `memory`.
  std::span<const CentredSample> draw(Random& random, Memory& memory) const;

 private:
  std::vector<CentredSample> measured_;
  std::vector<Distribution> truths_;
  std::vector<CensoringPlan> plans_;
};

SameShapeSamples::SameShapeSamples(std::span<const Sample> samples, const CommonShapeFit& common) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const CentredSample logs(Family::weibull, samples[i]);
    if (logs.bounded()) {
      measured_.push_back(logs);
      plans_.emplace_back(samples[i]);
      truths_.push_back(
          {.family = Family::weibull, .first = common.scales[i], .second = common.shape});
    }
  }
}

std::span<const CentredSample> SameShapeSamples::draw(Random& random, Memory& memory) const {
  memory.logs.resize(plans_.size());
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    plans_[i].draw(truths_[i], random, memory.lives);
    memory.logs[i].assign(Family::weibull, memory.lives);
  }
  return memory.logs;
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Log likelihood with one best shape, or NaN where there is none.
double best_log_likelihood(std::span<const CentredSample> samples) {
  if (shape_problem(samples) != FitProblem::none) {
    return kUnknown;
  }
  const double shape = solve_shape(samples);
  return shape == 0 ? kUnknown : shape_log_likelihood(samples, shape);
}

/// Eq. (18) for a shape in each group against one in all; `group_sizes` splits the samples in
/// order.
double likelihood_ratio(std::span<const CentredSample> samples,
                        std::span<const std::size_t> group_sizes) {
  double separate = 0;
  std::size_t begin = 0;
  for (const std::size_t size : group_sizes) {
    separate += best_log_likelihood(samples.subspan(begin, size));
    begin += size;
  }
  const double ratio = 2 * (separate - best_log_likelihood(samples));
  return ratio < 0 ? 0 : ratio;
}

Test test_groups(std::span<const Sample> samples, std::span<const std::size_t> group_sizes,
                 const BootstrapOptions& options) {
  Test test{.statistic = kUnknown,
            .degrees_of_freedom = static_cast<double>(group_sizes.size()) - 1,
            .p_chi_square = kUnknown,
            .p_simulated = kUnknown};
  const CommonShapeFit common = fit_common_shape(samples);
  if (common.problem != FitProblem::none) {
    return test;
  }
  const SameShapeSamples truth(samples, common);
  test.statistic = likelihood_ratio(truth.measured(), group_sizes);
  if (std::isnan(test.statistic)) {
    return test;
  }
  test.p_chi_square = boost::math::gamma_q(test.degrees_of_freedom / 2, test.statistic / 2);
  std::vector<double> replicates(options.replicates);
  for_each_replicate(options, [&] {
    return [&, drawn = SameShapeSamples::Memory()](Random& random, std::size_t i) mutable {
      replicates[i] = likelihood_ratio(truth.draw(random, drawn), group_sizes);
    };
  });
  test.p_simulated = bootstrap_p(replicates, test.statistic);
  return test;
}

bool has_shape(const Sample& sample) {
  return CentredSample(Family::weibull, sample).bounded() &&
         std::count_if(sample.begin(), sample.end(),
                       [](const Observation& seen) { return seen.failed; }) >= 2;
}

Test not_testable() {
  return {.statistic = kUnknown,
          .degrees_of_freedom = 0,
          .p_chi_square = kUnknown,
          .p_simulated = kUnknown};
}

}  // namespace

Test test_common_shape(std::span<const Sample> samples, const BootstrapOptions& options) {
  std::vector<Sample> usable;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(usable), has_shape);
  if (usable.size() < 2) {
    return not_testable();
  }
  return test_groups(usable, std::vector<std::size_t>(usable.size(), 1), options);
}

Test test_one_against_rest(std::span<const Sample> samples, std::size_t odd,
                           const BootstrapOptions& options) {
  if (!has_shape(samples[odd])) {
    return not_testable();
  }
  std::vector<Sample> usable{samples[odd]};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i != odd && has_shape(samples[i])) {
      usable.push_back(samples[i]);
    }
  }
  if (usable.size() < 2) {
    return not_testable();
  }
  return test_groups(usable, std::vector<std::size_t>{1, usable.size() - 1}, options);
}

double unbiased_shape(std::span<const Sample> samples, const CommonShapeFit& fit,
                      const BootstrapOptions& options) {
  const SameShapeSamples truth(samples, fit);
  std::vector<double> shapes(options.replicates);
  for_each_replicate(options, [&] {
    return [&, drawn = SameShapeSamples::Memory()](Random& random, std::size_t i) mutable {
      const auto logs = truth.draw(random, drawn);
      shapes[i] = shape_problem(logs) == FitProblem::none ? solve_shape(logs) : 0;
    };
  });
  double sum = 0;
  double fitted = 0;
  for (const double shape : shapes) {
    sum += shape;
    fitted += shape > 0 ? 1 : 0;
  }
  const double mean_ratio = sum / (fitted * fit.shape);
  return fitted == 0 ? std::numeric_limits<double>::quiet_NaN() : fit.shape / mean_ratio;
}

}  // namespace host_sim::statistics
