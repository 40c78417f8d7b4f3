#include "host_sim/diagnose/output/parts.hpp"

#include <gtest/gtest.h>

#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim::diagnose {
namespace {

TEST(Parts, RecordingsComeFirst) {
  const Diagnosis diagnosis = host_sim_test::both_parts();
  const auto parts = parts_of(diagnosis);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "recordings");
  EXPECT_EQ(parts[0].findings, &diagnosis.tension->findings);
  EXPECT_EQ(parts[1].findings, &diagnosis.lives->findings);
  EXPECT_TRUE(parts_of({}).empty());
}

TEST(Parts, MergedHoldAllOfBoth) {
  const Findings all = merged(host_sim_test::both_parts());
  EXPECT_EQ(all.verdict, Verdict::named);
  ASSERT_EQ(all.effects.size(), 2U);
  EXPECT_EQ(all.effects[1].id, "lot_frailty");
  EXPECT_EQ(all.candidates.size(), 4U);
  EXPECT_EQ(all.credible_set, (std::vector<std::string>{"friction_wear", "lot_frailty"}));
  EXPECT_EQ(all.equivalent_sets.size(), 1U);
  EXPECT_EQ(all.invisible.size(), 2U);
  EXPECT_EQ(all.next_experiment, "sweep the frequency; test more lots");
  EXPECT_EQ(all.discrepancies.size(), 2U);
  EXPECT_EQ(all.refitted.size(), 1U);
  EXPECT_EQ(all.extensions.size(), 2U);
  EXPECT_EQ(all.words, "Friction grows. Lots differ.");
}

TEST(Parts, AMetricOfBothKeepsBothValues) {
  const Gain gain = merged(host_sim_test::both_parts()).gain;
  EXPECT_EQ(gain.held_out_by, "session, level");
  ASSERT_EQ(gain.metrics.size(), 4U);
  EXPECT_EQ(gain.metrics[1].name, "log_predictive_density");
  EXPECT_EQ(gain.metrics[1].after, 3);
  EXPECT_EQ(gain.metrics[2].name, "lives_log_predictive_density");
  EXPECT_EQ(gain.metrics[2].after, 0.1);
}

TEST(Parts, OfOnePartAloneAreItsOwn) {
  Diagnosis diagnosis;
  diagnosis.lives = host_sim_test::lots_in_lives();
  const Findings all = merged(diagnosis);
  EXPECT_EQ(all.next_experiment, "test more lots");
  EXPECT_EQ(all.gain.metrics[0].name, "log_predictive_density");
}

}  // namespace
}  // namespace host_sim::diagnose
