#include <gtest/gtest.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/data_sets.hpp"

namespace host_sim::life_law {
namespace {

using QuantityKind = LifeQuantity::Kind;

/// The largest value of f between two bounds.
double largest(const std::function<double(double)>& f, double low, double high) {
  constexpr int kBits = 30;
  const auto [at, least] =
      boost::math::tools::brent_find_minima([&f](double x) { return -f(x); }, low, high, kBits);
  static_cast<void>(at);
  return -least;
}

/// ln alpha at the quantity's tension less the quantity.
double ln_alpha_above(const LifeQuantity& quantity, double shape) {
  switch (quantity.kind) {
    case QuantityKind::ln_mean_life:
      return -std::log(std::tgamma(1 + 1 / shape));
    case QuantityKind::ln_quantile:
      return -std::log(-std::log(1 - quantity.p)) / shape;
    case QuantityKind::ln_scale:
    case QuantityKind::exponent:
    case QuantityKind::shape:
      break;
  }
  return 0;
}

/// The profile log likelihood by nested searches over the other two parameters of the law, with
/// nothing but the likelihood.
class SearchedProfile {
 public:
  SearchedProfile(const LifeData& data, const LifeFit& fit, const LifeQuantity& quantity)
      : data_(data), fit_(fit), quantity_(quantity) {}

  double operator()(double value) const {
    const double shape = fit_.law().shape;
    const double exponent = fit_.law().exponent;
    if (quantity_.kind == QuantityKind::shape) {
      return over_exponent([&](double e) { return over_ln_alpha(e, value); }, exponent);
    }
    return largest(
        [&](double b) {
          if (quantity_.kind == QuantityKind::exponent) {
            return over_ln_alpha(value, b);
          }
          return over_exponent([&](double e) { return of(ln_alpha_at_centre(value, e, b), e, b); },
                               exponent);
        },
        0.4 * shape, 2 * shape);
  }

 private:
  static double over_exponent(const std::function<double(double)>& f, double exponent) {
    return largest(f, 0.3 * exponent, 2 * exponent);
  }

  double over_ln_alpha(double exponent, double shape) const {
    return largest([&](double a) { return of(a, exponent, shape); }, fit_.scale[0] - 1,
                   fit_.scale[0] + 1);
  }

  double ln_alpha_at_centre(double value, double exponent, double shape) const {
    const double tension_N =
        quantity_.kind == QuantityKind::ln_scale ? 1 : quantity_.effective_tension_N;
    const double x = std::log(tension_N) - fit_.centre_ln_N;
    return value + ln_alpha_above(quantity_, shape) + exponent * x;
  }

  double of(double ln_alpha, double exponent, double shape) const {
    LifeFit there = fit_;
    there.scale = {ln_alpha, exponent};
    there.shape = {std::log(shape)};
    return log_likelihood(data_, there);
  }

  const LifeData& data_;
  const LifeFit& fit_;
  const LifeQuantity& quantity_;
};

LifeData campaign() {
  LifeData data = testing::suspended_at(testing::paper_like(12, 8), 900);
  const LifeData blocks = testing::in_blocks(12, 5, 0.4);
  data.insert(data.end(), blocks.begin(), blocks.end());
  return data;
}

class ProfileInterval : public ::testing::TestWithParam<LifeQuantity> {};

// 3.841459 is the 0.95 point of chi-square with one degree of freedom.
TEST_P(ProfileInterval, EndsWhereTheSearchedProfileLosesHalfOfChiSquare) {
  const LifeData data = campaign();
  const LifeFit fit = fit_life(data);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  const LifeQuantity quantity = GetParam();
  const statistics::Interval interval = profile_interval(data, fit, quantity);
  const SearchedProfile profile(data, fit, quantity);
  EXPECT_NEAR(2 * (fit.log_likelihood - profile(interval.low)), 3.841459, 1e-4);
  EXPECT_NEAR(2 * (fit.log_likelihood - profile(interval.high)), 3.841459, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Quantities, ProfileInterval,
                         ::testing::Values(LifeQuantity{QuantityKind::ln_scale},
                                           LifeQuantity{QuantityKind::exponent},
                                           LifeQuantity{QuantityKind::shape},
                                           LifeQuantity{QuantityKind::ln_mean_life, 35.1},
                                           LifeQuantity{QuantityKind::ln_quantile, 35.1, 0.1},
                                           LifeQuantity{QuantityKind::ln_quantile, 25.5, 0.9}));

double estimate_of(const LifeLaw& law, const LifeQuantity& quantity) {
  switch (quantity.kind) {
    case QuantityKind::ln_scale:
      return std::log(law.scale);
    case QuantityKind::exponent:
      return law.exponent;
    case QuantityKind::shape:
      return law.shape;
    case QuantityKind::ln_mean_life:
      return std::log(law.mean_life(quantity.effective_tension_N));
    case QuantityKind::ln_quantile:
      break;
  }
  return std::log(law.quantile(quantity.p, quantity.effective_tension_N));
}

// Small campaigns too: two levels of three.
TEST_P(ProfileInterval, HoldsTheEstimateAndWidensWithConfidence) {
  const LifeQuantity quantity = GetParam();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    LifeData data = testing::paper_like(seed, 3);
    data.resize(6);
    const LifeFit fit = fit_life(data);
    ASSERT_EQ(fit.problem, statistics::FitProblem::none);
    const double estimate = estimate_of(fit.law(), quantity);
    statistics::Interval inner{.low = estimate, .high = estimate};
    for (const double confidence : {0.5, 0.9, 0.99, 0.9999}) {
      const statistics::Interval outer = profile_interval(data, fit, quantity, confidence);
      EXPECT_LT(outer.low, inner.low) << seed << ' ' << confidence;
      EXPECT_GT(outer.high, inner.high) << seed << ' ' << confidence;
      inner = outer;
    }
    EXPECT_TRUE(std::isfinite(inner.low) && std::isfinite(inner.high)) << seed;
  }
}

// ln A is ln alpha at 1 N, where 63.2 % have failed.
TEST(ProfileIntervalOfAQuantile, AtOneLessOneOverEIsThatOfAlpha) {
  const LifeData data = campaign();
  const LifeFit fit = fit_life(data);
  const statistics::Interval scale = profile_interval(data, fit, {QuantityKind::ln_scale});
  const statistics::Interval quantile =
      profile_interval(data, fit, {QuantityKind::ln_quantile, 1, 1 - std::exp(-1)});
  EXPECT_NEAR(scale.low, quantile.low, 1e-7);
  EXPECT_NEAR(scale.high, quantile.high, 1e-7);
}

/// Lives of one kind at two tensions, `twice` of each at the second.
LifeData same_scatter(double first_N, double second_N, int twice) {
  LifeData data;
  for (const double life : {70.0, 85.0, 100.0, 104.0, 131.0}) {
    data.push_back({.blocks = {{first_N, life}}, .level = 0});
    for (int i = 0; i < twice; ++i) {
      data.push_back({.blocks = {{second_N, life / 2}}, .level = 1});
    }
  }
  return data;
}

// With the same scatter at each tension the shape says nothing of the exponent, and ln alpha at the
// mean of ln tension does not either: sqrt(36 * 64) = 48, and (36 * 64 * 64)^(1/3) = 52.8308.
TEST(PivotTension, IsTheGeometricMeanWhereTheScatterIsTheSame) {
  const LifeData even = same_scatter(36, 64, 1);
  EXPECT_NEAR(pivot_tension_N(even, fit_life(even)), 48, 1e-6);
  const LifeData uneven = same_scatter(36, 64, 2);
  EXPECT_NEAR(pivot_tension_N(uneven, fit_life(uneven)), 52.8308, 1e-4);
}

/// Second differences of the log likelihood in (ln alpha at `tension_N`, exponent, ln shape).
double second_difference(const LifeData& data, const LifeFit& fit, std::size_t i, std::size_t j) {
  constexpr double kStep = 1e-3;
  const auto at = [&](double along_i, double along_j) {
    double move[3] = {};
    move[i] += along_i * kStep;
    move[j] += along_j * kStep;
    LifeFit there = fit;
    there.scale[0] += move[0];
    there.scale[1] += move[1];
    there.shape[0] += move[2];
    return log_likelihood(data, there);
  };
  return (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * kStep * kStep);
}

// The covariance of (a, g) of a 3 by 3 inverse by its cofactors.
TEST(PivotTension, IsWhereLifeAndExponentDoNotCorrelate) {
  const LifeData data = campaign();
  const LifeFit fit = fit_life(data);
  const auto h = [&](std::size_t i, std::size_t j) { return second_difference(data, fit, i, j); };
  const double shared = h(0, 2) * h(1, 2) - h(0, 1) * h(2, 2);
  const double exponent = h(0, 0) * h(2, 2) - h(0, 2) * h(0, 2);
  EXPECT_NEAR(std::log(pivot_tension_N(data, fit)), fit.centre_ln_N + shared / exponent, 1e-4);
}

}  // namespace
}  // namespace host_sim::life_law
