#include "host_sim/diagnose/tension/imitation.hpp"

#include <gtest/gtest.h>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

/// Sessions that friction with temperature moves by some per cent, and what each end's noise is
/// said to be.
std::vector<Session> warm_sessions(double variance) {
  const Disturbances disturbances{.sample_sd = 0.01,
                                  .session_gain_sd = 0.001,
                                  .session_friction_sd = 0.0005,
                                  .effect = [](const recording::Covariates& c, std::size_t i) {
                                    return -kMu * 0.02 * (c.sheath_temperature_C[i] - 20) *
                                           c.bend_angle_rad[i] * c.direction[i];
                                  }};
  std::vector<Session> sessions = noisy_sessions(small_design(), disturbances, 1);
  for (Session& session : sessions) {
    session.covariates.input_noise.assign(session.covariates.samples(), variance);
    session.covariates.output_noise.assign(session.covariates.samples(), variance);
  }
  return sessions;
}

TEST(BeyondNoise, LeavesWhatIsLargerThanTheVariances) {
  const std::vector<Component> parts{component("friction_temperature")};
  const std::vector<Session> quiet = warm_sessions(1e-4);
  EXPECT_EQ(beyond_noise(evidence_of(quiet, 0.01), parts).size(), 1U);
  const std::vector<Session> loud = warm_sessions(0.25);
  EXPECT_TRUE(beyond_noise(evidence_of(loud, 0.01), parts).empty());
}

/// A second part that nothing in the sessions calls for.
TEST(BeyondNoise, JudgesEachPartByItself) {
  const std::vector<Component> parts{component("friction_temperature"),
                                     component("current_offset", {0.001})};
  const std::vector<Session> sessions = warm_sessions(1e-3);
  const std::vector<Component> kept = beyond_noise(evidence_of(sessions, 0.01), parts);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept.front().effect->id(), "friction_temperature");
}

TEST(BeyondNoise, WithoutKnownNoiseAllStay) {
  std::vector<Session> sessions = warm_sessions(0);
  EXPECT_EQ(beyond_noise(evidence_of(sessions, 0.01), {component("friction_temperature")}).size(),
            1U);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
