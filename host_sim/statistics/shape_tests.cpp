#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/replicates.hpp"
#include "host_sim/statistics/same_shape_samples.hpp"
#include "host_sim/statistics/shape_equation.hpp"

namespace host_sim::statistics {
namespace {

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
  return std::count_if(sample.begin(), sample.end(),
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

}  // namespace host_sim::statistics
