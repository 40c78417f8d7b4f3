#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/data_sets.hpp"

namespace host_sim::life_law {
namespace {

using testing::sum_of_ln_failures;

constexpr LifeForm kCurved{.scale = LifeForm::Scale::curved};
constexpr LifeForm kCurvedGrowing{.scale = LifeForm::Scale::curved,
                                  .shape = LifeForm::Shape::growing};

/// ln alpha = a + b ln V + c (ln V)^2, ln sigma = d + e ln V: coefficients as they are published.
struct Uncentred {
  double a, b, c, d, e;
};

Uncentred uncentred(const LifeFit& fit) {
  const double m = fit.centre_ln_N;
  const double c = fit.form.scale == LifeForm::Scale::curved ? fit.scale[2] : 0;
  const double s = fit.form.shape == LifeForm::Shape::growing ? fit.shape[1] : 0;
  return {.a = fit.scale[0] + fit.scale[1] * m + c * m * m,
          .b = -fit.scale[1] - 2 * c * m,
          .c = c,
          .d = -fit.shape[0] + s * m,
          .e = -s};
}

/// Books give it for the logarithms of the lives.
double log_likelihood_of_ln_lives(const LifeFit& fit, const LifeData& data) {
  return fit.log_likelihood + sum_of_ln_failures(data);
}

// Lawless (1982), section 6.4: ln alpha = 64.85 - 17.73 ln V, sigma 1.288, log likelihood -137.748.
TEST(Published, InsulatingFluidWithAPowerLaw) {
  const LifeData data = testing::insulating_fluid();
  const LifeFit fit = fit_life(data);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  EXPECT_NEAR(uncentred(fit).a, 64.85, 0.005);
  EXPECT_NEAR(fit.law().exponent, 17.73, 0.005);
  EXPECT_NEAR(1 / fit.law().shape, 1.288, 0.0005);
  EXPECT_NEAR(log_likelihood_of_ln_lives(fit, data), -137.748, 0.0005);
}

// SAS/QC user's guide, the RELIABILITY procedure, "Regression modeling".
TEST(Published, RollingBearingsWithAPowerLaw) {
  const LifeData data = testing::rolling_bearings();
  const LifeFit fit = fit_life(data);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  EXPECT_NEAR(uncentred(fit).a, 0.8323, 0.00005);
  EXPECT_NEAR(fit.law().exponent, 13.8529, 0.00005);
  EXPECT_NEAR(fit.law().shape, 1.2434, 0.00005);
  EXPECT_NEAR(log_likelihood_of_ln_lives(fit, data), -51.77737, 0.000005);
}

// SAS/STAT user's guide, the LIFEREG procedure, "Motorette failure".
TEST(Published, MotorettesWithSuspendedOnes) {
  const LifeData data = testing::motorettes();
  const LifeFit fit = fit_life(data);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  EXPECT_NEAR(uncentred(fit).a, -11.8912, 0.00005);
  EXPECT_NEAR(fit.law().exponent, 9.0383, 0.00005);
  EXPECT_NEAR(fit.law().shape, 2.7679, 0.00005);
  EXPECT_NEAR(log_likelihood_of_ln_lives(fit, data), -22.95148315, 5e-9);
}

// Meeker and Escobar (1998), table 17.2: Weibull, quadratic in log stress, constant sigma.
TEST(Published, SuperalloyIsCurvedInLogStress) {
  const LifeFit fit = fit_life(testing::superalloy(), kCurved);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  const Uncentred published = uncentred(fit);
  EXPECT_NEAR(published.a, 217.61, 0.005);
  EXPECT_NEAR(published.b, -85.52, 0.005);
  EXPECT_NEAR(published.c, 8.48, 0.005);
  EXPECT_NEAR(std::exp(published.d), 0.375, 0.0005);
}

// The same with ln sigma linear in log stress.
TEST(Published, SuperalloyWithScatterThatGrowsAsStressFalls) {
  const LifeFit fit = fit_life(testing::superalloy(), kCurvedGrowing);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  const Uncentred published = uncentred(fit);
  EXPECT_NEAR(published.a, 243.2, 0.05);
  EXPECT_NEAR(published.b, -96.54, 0.02);
  EXPECT_NEAR(published.c, 9.67, 0.005);
  EXPECT_NEAR(published.d, 4.47, 0.005);
  EXPECT_NEAR(published.e, -1.18, 0.005);
}

}  // namespace
}  // namespace host_sim::life_law
