#include "tests/statistics/survreg/survreg.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "host_sim/statistics/fit.hpp"
#include "tests/statistics/published.hpp"

namespace host_sim::statistics {
namespace {

std::vector<survreg::Row> rows_of(const Sample& sample) {
  std::vector<survreg::Row> rows;
  for (const Observation& seen : sample) {
    rows.push_back({.life = seen.value, .failed = seen.failed});
  }
  return rows;
}

/// Six digits of a number.
double six_digits(double value) {
  return 1e-6 * std::abs(value);
}

/// The same parameters as survreg has: location and scale of the life or of its logarithm.
struct LocationScale {
  double location;
  double scale;
};
LocationScale location_scale(const Distribution& distribution) {
  if (distribution.family == Family::weibull) {
    return {.location = std::log(distribution.first), .scale = 1 / distribution.second};
  }
  return {.location = distribution.first, .scale = distribution.second};
}

void expect_as_survreg(const Sample& sample) {
  const std::array<std::string, 3> names{"gaussian", "lognormal", "weibull"};
  const std::array<Family, 3> families{Family::normal, Family::lognormal, Family::weibull};
  const std::vector<survreg::Fit> theirs = survreg::fit(rows_of(sample), "1", names);
  for (std::size_t i = 0; i < families.size(); ++i) {
    SCOPED_TRACE(names[i]);
    const Fit ours = fit(families[i], sample);
    ASSERT_EQ(ours.problem, FitProblem::none);
    EXPECT_NEAR(ours.log_likelihood, theirs[i].log_likelihood,
                six_digits(theirs[i].log_likelihood));
    const auto [location, scale] = location_scale(ours.distribution);
    EXPECT_NEAR(location, theirs[i].coefficients.at(0), six_digits(location));
    EXPECT_NEAR(scale, theirs[i].scale, six_digits(scale));
  }
}

TEST(Survreg, FindsTheSameMaximum) {
  if (!survreg::available()) {
    GTEST_SKIP() << "Rscript with package survival is not installed (Debian: r-cran-survival)";
  }
  expect_as_survreg(published::ball_bearings());
  expect_as_survreg(published::generator_fans());
  expect_as_survreg(published::nist_units());
  expect_as_survreg(published::shock_absorbers());
  expect_as_survreg(published::alloy_t7987());
}

}  // namespace
}  // namespace host_sim::statistics
