#include "host_sim/statistics/common_shape.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
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
  std::span<CentredSample> draw(Random& random, Memory& memory) const;

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

std::span<CentredSample> SameShapeSamples::draw(Random& random, Memory& memory) const {
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

/// Eq. (18) against one shape for all of some samples. NaN where a part of them has no best shape.
class ShapeRatios {
 public:
  /// @param samples are moved about, and in their places again after each call
  explicit ShapeRatios(std::span<CentredSample> samples)
      : samples_(samples), all_(best_log_likelihood(samples)) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      each_.push_back(best_log_likelihood(samples.subspan(i, 1)));
    }
  }

  /// Of a shape for each.
  [[nodiscard]] double of_each() const {
    return ratio(std::accumulate(each_.begin(), each_.end(), 0.0));
  }
  /// Of a shape for one, and another for the rest.
  [[nodiscard]] double of_one(std::size_t odd) const {
    std::swap(samples_[0], samples_[odd]);
    const double rest = best_log_likelihood(samples_.subspan(1));
    std::swap(samples_[0], samples_[odd]);
    return ratio(each_[odd] + rest);
  }

 private:
  [[nodiscard]] double ratio(double separate) const {
    const double twice = 2 * (separate - all_);
    return twice < 0 ? 0 : twice;
  }

  std::span<CentredSample> samples_;
  double all_;
  std::vector<double> each_;
};

/// In place of the sample that is tested against the rest: a shape for each.
constexpr std::size_t kEach = std::numeric_limits<std::size_t>::max();

double ratio_of(const ShapeRatios& ratios, std::size_t tested) {
  return tested == kEach ? ratios.of_each() : ratios.of_one(tested);
}

/// Tests of samples with shapes, all by the same replicates.
std::vector<Test> tests_of(std::span<const Sample> samples, std::span<const std::size_t> tested,
                           const BootstrapOptions& options) {
  std::vector<Test> tests;
  for (const std::size_t one : tested) {
    tests.push_back(
        {.statistic = kUnknown,
         .degrees_of_freedom = one == kEach ? static_cast<double>(samples.size()) - 1 : 1,
         .p_chi_square = kUnknown,
         .p_simulated = kUnknown});
  }
  const CommonShapeFit common = fit_common_shape(samples);
  if (common.problem != FitProblem::none) {
    return tests;
  }
  const SameShapeSamples truth(samples, common);
  std::vector<CentredSample> measured(truth.measured().begin(), truth.measured().end());
  const ShapeRatios ratios(measured);
  std::vector<std::vector<double>> replicates(tested.size());
  for (std::size_t t = 0; t < tested.size(); ++t) {
    tests[t].statistic = ratio_of(ratios, tested[t]);
    replicates[t].resize(options.replicates);
  }
  for_each_replicate(options, [&] {
    return [&, drawn = SameShapeSamples::Memory()](Random& random, std::size_t i) mutable {
      const ShapeRatios of_drawn(truth.draw(random, drawn));
      for (std::size_t t = 0; t < tested.size(); ++t) {
        replicates[t][i] = ratio_of(of_drawn, tested[t]);
      }
    };
  });
  for (std::size_t t = 0; t < tested.size(); ++t) {
    if (Test& test = tests[t]; !std::isnan(test.statistic)) {
      test.p_chi_square = boost::math::gamma_q(test.degrees_of_freedom / 2, test.statistic / 2);
      test.p_simulated = bootstrap_p(replicates[t], test.statistic);
    }
  }
  return tests;
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

ShapeTests test_shapes(std::span<const Sample> samples, const BootstrapOptions& options) {
  std::vector<Sample> usable;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (has_shape(samples[i])) {
      places.push_back(i);
      usable.push_back(samples[i]);
    }
  }
  ShapeTests tests{not_testable(), std::vector<Test>(samples.size(), not_testable())};
  if (usable.size() < 2) {
    return tests;
  }
  std::vector<std::size_t> tested(usable.size() + 1, kEach);
  std::iota(tested.begin() + 1, tested.end(), std::size_t{0});
  const std::vector<Test> found = tests_of(usable, tested, options);
  tests.common = found.front();
  for (std::size_t i = 0; i < places.size(); ++i) {
    tests.one_against_rest[places[i]] = found[i + 1];
  }
  return tests;
}

Test test_common_shape(std::span<const Sample> samples, const BootstrapOptions& options) {
  std::vector<Sample> usable;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(usable), has_shape);
  return usable.size() < 2 ? not_testable()
                           : tests_of(usable, std::span(&kEach, 1), options).front();
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
