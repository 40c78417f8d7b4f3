#include "host_sim/diagnose/tension/steps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/diagnose/tension/model_fit.hpp"
#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

TEST(Steps, BeginWithTheNominalModelAndAddWhatIsThere) {
  const Disturbances disturbances{.sample_sd = 0.01,
                                  .session_gain_sd = 0.001,
                                  .session_friction_sd = 0.0005,
                                  .effect = [](const recording::Covariates& c, std::size_t i) {
                                    return -kMu * 0.02 * (c.sheath_temperature_C[i] - 20) *
                                           c.bend_angle_rad[i] * c.direction[i];
                                  }};
  const std::vector<Session> sessions = noisy_sessions(small_design(), disturbances, 1);
  const std::vector<Step> steps =
      steps_of(evidence_of(sessions, 0.01), whole_catalogue(), 1, kWire);
  ASSERT_GE(steps.size(), 2U);
  EXPECT_TRUE(steps[0].effect.id.empty());
  EXPECT_EQ(steps[1].effect.id, "friction_temperature");
  EXPECT_GT(steps[1].effect.probability, 0.95);
  ASSERT_EQ(steps[1].effect.parameters.size(), 1U);
  EXPECT_NEAR(steps[1].effect.parameters[0].value, 0.02, 0.005);
  EXPECT_LT(steps[1].output_rmse_N, steps[0].output_rmse_N);
  EXPECT_LT(steps[1].input_rmse_N, steps[0].input_rmse_N);
  EXPECT_GT(steps[1].log_predictive_density, steps[0].log_predictive_density);
  EXPECT_GT(steps[1].sessions_better, 6);
  EXPECT_EQ(steps[1].sessions, 12);
}

/// T_out = (T_in - F s) exp(-mu phi s), and the other way round, whatever the tension that is asked
/// for was measured as.
TEST(Predicted, IsOfTheOtherTensionAlone) {
  std::vector<Session> sessions = sessions_of(small_design());
  const Session& measured = sessions[3];
  const Evidence evidence = evidence_of(sessions, 0.01);
  const std::vector<Component> preload{component("friction_preload", {4})};
  const GramLayout layout = layout_of(sessions, evidence.options.baseline, wanted_of(preload));
  const ModelFit fit{.noise = {}, .coefficients = Eigen::Vector3d(0, 0, 1), .covariance = {}};
  const Predicted predicted = predict(measured, layout, evidence.options.baseline, fit);
  const recording::Covariates& c = measured.covariates;
  for (std::size_t i = 0; i < c.samples(); ++i) {
    const double gripped = std::exp(kMu * c.bend_angle_rad[i] * c.direction[i]);
    const double preload_N = 4 * c.direction[i];
    ASSERT_NEAR(predicted.output_N[i], (c.tension_in_N()[i] - preload_N) / gripped, 1e-2);
    ASSERT_NEAR(predicted.input_N[i], c.output_tension_N[i] * gripped + preload_N, 1e-2);
  }
}

}  // namespace
}  // namespace host_sim::diagnose::testing
