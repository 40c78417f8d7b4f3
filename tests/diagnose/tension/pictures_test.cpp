#include "host_sim/diagnose/tension/pictures.hpp"

#include <gtest/gtest.h>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose {
namespace {

TEST(SessionRefits, GiveTheGainOfTheSessionThatHasOne) {
  testing::Disturbances disturbances{.sample_sd = 0.001,
                                     .ar1 = 0,
                                     .session_gain_sd = 0,
                                     .session_friction_sd = 0,
                                     .effect = nullptr};
  std::vector<Session> sessions = testing::noisy_sessions(testing::small_design(), disturbances, 1);
  disturbances.effect = [](const recording::Covariates&, std::size_t) { return 0.05; };
  sessions[3] = testing::noisy_sessions(testing::small_design(), disturbances, 1)[3];
  const Evidence evidence = testing::evidence_of(sessions, 0.001);
  const std::vector<SessionRefit> refits = session_refits(evidence);
  ASSERT_EQ(refits.size(), sessions.size());
  for (std::size_t i = 0; i < refits.size(); ++i) {
    EXPECT_EQ(refits[i].session, sessions[i].name);
    EXPECT_NEAR(refits[i].log_gain, i == 3 ? 0.05 : 0, 0.002) << i;
    EXPECT_NEAR(refits[i].friction_coefficient, evidence.options.baseline.friction_coefficient,
                0.002)
        << i;
  }
}

}  // namespace
}  // namespace host_sim::diagnose
