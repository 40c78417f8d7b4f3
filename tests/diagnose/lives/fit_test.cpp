#include "host_sim/diagnose/lives/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnose/lives/estimates.hpp"
#include "host_sim/diagnose/lives/hypotheses.hpp"
#include "host_sim/diagnose/lives/maximize.hpp"
#include "host_sim/diagnose/lives/terms.hpp"
#include "tests/diagnose/lives/scenario.hpp"

namespace host_sim::diagnose::lives {
namespace {

double hill(const Eigen::VectorXd& at) {
  return -std::pow(at[0] - 1, 2) - 2 * std::pow(at[1] + 0.5, 2) - at[0] * at[1];
}

// Zero slopes 2 (x - 1) + y = 0 and 4 (y + 1/2) + x = 0: x = 10/7, y = -6/7.
TEST(Climb, FindsTheTopOfAHill) {
  const Eigen::VectorXd top = maximize(hill, Eigen::VectorXd::Zero(2));
  EXPECT_NEAR(top[0], 10.0 / 7, 1e-4);
  EXPECT_NEAR(top[1], -6.0 / 7, 1e-4);
}

TEST(Climb, SeesCurvature) {
  const Eigen::MatrixXd curvature = hessian(hill, Eigen::Vector2d(0.3, 0.2));
  EXPECT_NEAR(curvature(0, 0), -2, 1e-6);
  EXPECT_NEAR(curvature(1, 1), -4, 1e-6);
  EXPECT_NEAR(curvature(0, 1), -1, 1e-6);
}

class LifeFits : public ::testing::Test {
 protected:
  static LifeSample sample_of_hidden(const std::string& hidden, std::uint64_t seed) {
    return sample_of(host_sim::test::simulated({96, hidden, seed}), Campaign::Role::fit);
  }
};

TEST_F(LifeFits, TheNominalLawIsNearlyThatOfMaximumLikelihood) {
  const LifeSample sample = sample_of_hidden("none", 20001);
  const NominalFit nominal = fit_nominal(sample);
  const ModelView view(sample, common_prior(sample), {});
  const ModelFit fit = fit_model(view);
  EXPECT_LE(fit.log_likelihood, nominal.log_likelihood + 1e-6);
  EXPECT_NEAR(fit.log_likelihood, nominal.log_likelihood, 0.1);
  EXPECT_NEAR(view.settings(fit.at).exponent, nominal.exponent, 0.03 * nominal.exponent);
}

// Under the model's gamma of 1.38 and beta of 5.94 these lives have a probability of exp(-1e9).
TEST_F(LifeFits, AModelThatIsFarOffIsLetGoOf) {
  LifeSample sample = sample_of_hidden("none", 20001);
  for (LifeSample::Specimen& specimen : sample.specimens) {
    for (LifeSample::Block& block : specimen.blocks) {
      block.cycles *= std::pow(block.effective_N / 40, -14);
    }
  }
  const NominalFit nominal = fit_nominal(sample);
  for (const bool modelled : {true, false}) {
    if (!modelled) {
      sample.nominal.reset();
    }
    const ModelView view(sample, common_prior(sample), {});
    const ModelFit fit = fit_model(view);
    EXPECT_NEAR(fit.log_likelihood, nominal.log_likelihood, 1);
    EXPECT_NEAR(view.settings(fit.at).exponent, nominal.exponent, 0.1 * nominal.exponent);
  }
}

// The integral over a coordinate that the data say nothing of is that of its prior: 1.
TEST_F(LifeFits, EvidenceIgnoresAParameterWithoutAnEffect) {
  const LifeSample sample = sample_of_hidden("none", 20001);
  const CommonPrior prior = common_prior(sample);
  const Model idle{{.id = "idle",
                    .parameters = {shift("nothing", 1)},
                    .apply = [](std::span<const double>, LifeSettings&) {}}};
  const double with = fit_model(ModelView(sample, prior, idle)).log_evidence;
  EXPECT_NEAR(with, fit_model(ModelView(sample, prior, {})).log_evidence, 1e-3);
}

// Laplace against the sum over a fine grid of the shift, each with the rest by Laplace.
TEST_F(LifeFits, EvidenceIsTheIntegralOverAnEffect) {
  const LifeSample sample = sample_of_hidden("ageing", 20002);
  const CommonPrior prior = common_prior(sample);
  const Model ageing{terms_of("ageing", sample).front()};
  const double evidence = fit_model(ModelView(sample, prior, ageing)).log_evidence;
  double sum = 0;
  constexpr double kStep = 0.1;
  for (double u = -5; u <= 5; u += kStep) {
    const double rate_1_day = ageing.front().parameters.front().value(u);
    const Model fixed{{.id = "fixed", .apply = [rate_1_day](auto, LifeSettings& settings) {
                         settings.ageing_1_day = rate_1_day;
                       }}};
    sum += kStep * std::exp(-u * u / 2 - evidence +
                            fit_model(ModelView(sample, prior, fixed)).log_evidence);
  }
  EXPECT_NEAR(std::log(sum) - std::log(2 * 3.14159265) / 2, 0, 0.1);
}

// At the ends of the interval twice the log likelihood is 3.841 below its maximum.
TEST_F(LifeFits, IntervalsEndWhereTheProfileDoes) {
  const LifeSample sample = sample_of_hidden("lot_frailty", 20003);
  const Model model{terms_of("lot_frailty", sample).front()};
  const ModelView view(sample, common_prior(sample), model);
  const ModelFit fit = fit_model(view);
  const CoordinateInterval interval = profile_interval(view, fit, view.first(0));
  for (const double end : {interval.low, interval.high}) {
    const ModelFit at = fit_with_fixed(view, view.first(0), end, fit.at);
    EXPECT_NEAR(2 * (fit.log_posterior - at.log_posterior), 3.841, 0.15);
  }
  EXPECT_LT(interval.low, fit.at[view.first(0)]);
  EXPECT_GT(interval.high, fit.at[view.first(0)]);
}

}  // namespace
}  // namespace host_sim::diagnose::lives
