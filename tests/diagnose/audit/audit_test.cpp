#include "host_sim/diagnose/audit/audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "host_sim/diagnose/audit/projection.hpp"
#include "tests/diagnose/audit/records.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Verdict = EffectAudit::Verdict;

Audit audit_of(const std::vector<effects::ForceRecord>& records) {
  return audit(records, testing::kMu, testing::usual_noise(records), 0);
}

/// One pose, and a sheath that warms by 25 K as cycles run: 20 C + 25 K (1 - exp(-n/1500)).
std::vector<testing::Run> warming_with_cycles() {
  std::vector<testing::Run> runs = testing::one_pose();
  for (testing::Run& run : runs) {
    const auto sheath_C = [](double cycle) { return 20 + 25 * (1 - std::exp(-cycle / 1500)); };
    run.sheath_C = sheath_C(run.start_cycle);
    run.warming_C = sheath_C(run.start_cycle + 5) - run.sheath_C;
  }
  return runs;
}

TEST(Audit, OnePoseLeavesNothingOfGearAsymmetryAndBendAngle) {
  const Audit found = audit_of(testing::records_of(testing::one_pose()));
  for (const char* id : {"gear_asymmetry", "bend_angle"}) {
    EXPECT_EQ(found.of(id).verdict, Verdict::nothing_left) << id;
    EXPECT_LT(found.of(id).share, 1e-4) << id;
    EXPECT_THAT(found.of(id).prose, HasSubstr("0.0 %")) << id;
    EXPECT_THAT(found.of(id).prose, HasSubstr("four or more bend angles")) << id;
  }
  EXPECT_TRUE(found.of("friction_position").visible());
  EXPECT_EQ(found.pair("gear_asymmetry", "slack"), nullptr);
}

TEST(Audit, WearLooksLikeTemperatureWhereTheSheathWarmsWithCycles) {
  const Audit found = audit_of(testing::records_of(warming_with_cycles()));
  const PairAudit* pair = found.pair("friction_wear", "friction_temperature");
  ASSERT_NE(pair, nullptr);
  EXPECT_GT(pair->cosine, 0.95);
  EXPECT_THAT(pair->experiment, HasSubstr("heat the sheath alone"));
  EXPECT_THAT(found.prose,
              HasSubstr("friction_temperature, friction_wear cannot be distinguished"));
}

/// |cos| of the two columns in nine values, one a session, by least squares written out: with a
/// scatter between sessions far above what samples say of one, that is all that is left. At one
/// pose what is refitted is the mean.
TEST(Audit, CosineIsThatOfTheSessionMeansWhereScatterRules) {
  std::vector<testing::Run> runs = testing::one_pose();
  Eigen::VectorXd wear(9);
  Eigen::VectorXd temperature(9);
  for (Eigen::Index i = 0; i < 9; ++i) {
    testing::Run& run = runs[static_cast<std::size_t>(i)];
    // Few cycles and kelvins: what they do to the force is in proportion to them.
    run.start_cycle = static_cast<double>(i);
    run.sheath_C = 20.05 + 0.01 * static_cast<double>((i * i) % 7) + 0.02 * static_cast<double>(i);
    run.warming_C = 0;
    wear(i) = run.start_cycle;
    temperature(i) = run.sheath_C;
  }
  wear.array() -= wear.mean();
  temperature.array() -= temperature.mean();
  const double expected = std::abs(wear.dot(temperature)) / (wear.norm() * temperature.norm());
  auto records = testing::records_of(runs);
  for (effects::ForceRecord& record : records) {
    record.cycle.assign(record.samples(), record.cycle.front());
  }
  NoiseModel noise = testing::usual_noise(records);
  noise.session_gain_sd = 0.1;
  noise.session_friction_sd = 0.1;
  const Grams grams = gram_of(records, testing::kMu, noise, 0);
  const Projection projection = project(grams, noise);
  const auto column = [&](std::string_view id) {
    return static_cast<Eigen::Index>(grams.layout.of(id).cases.front().first);
  };
  const Eigen::Index a = column("friction_wear");  // exponent 1
  const Eigen::Index b = column("friction_temperature");
  const double found =
      std::abs(projection.left(a, b)) / std::sqrt(projection.left(a, a) * projection.left(b, b));
  EXPECT_NEAR(found, expected, 1e-3);
}

/// But for a delay of 5 ms: what it differs in from a lag goes with the square of both times.
TEST(Audit, ACrossedDesignTellsAllEffectsApart) {
  const Audit found = audit_of(testing::records_of(testing::crossed()));
  for (const EffectAudit& effect : found.effects) {
    EXPECT_TRUE(effect.visible()) << effect.effect->id << ": " << effect.prose;
    EXPECT_THAT(effect.prose, HasSubstr("standard deviations"));
  }
  EXPECT_EQ(found.pairs.size(), found.effects.size() * (found.effects.size() - 1) / 2);
  const PairAudit* const late = found.pair("channel_delay", "filter_lag");
  ASSERT_NE(late, nullptr);
  EXPECT_GT(late->cosine, 0.98);
  for (const PairAudit& pair : found.pairs) {
    EXPECT_TRUE(pair.cosine <= 0.9 || &pair == late)
        << found.effects[pair.first].effect->id << ' ' << found.effects[pair.second].effect->id;
    EXPECT_FALSE(pair.experiment.empty());
  }
  EXPECT_EQ(found.classes.size(), found.effects.size() - 1);
  for (const EquivalenceClass& members : found.classes) {
    EXPECT_EQ(members.experiments.size(), members.members.size() - 1);
  }
  EXPECT_THAT(found.prose, ::testing::StartsWith("channel_delay, filter_lag cannot be"));
}

TEST(Audit, AMissingChannelIsSaidWithItsName) {
  auto records = testing::records_of(testing::one_pose());
  records[4].winding_temperature_C.clear();
  const Audit found = audit_of(records);
  EXPECT_EQ(found.of("torque_gain").verdict, Verdict::missing_channel);
  EXPECT_THAT(found.of("torque_gain").prose, HasSubstr("winding_temperature_C"));
  EXPECT_THAT(found.prose, HasSubstr("torque_gain is not detectable: no winding temperature"));
}

TEST(Audit, AConstantSheathTemperatureLeavesNothing) {
  std::vector<testing::Run> runs = testing::one_pose();
  for (testing::Run& run : runs) {
    run.sheath_C = 31;
    run.warming_C = 0;
  }
  EXPECT_EQ(audit_of(testing::records_of(runs)).of("friction_temperature").verdict,
            Verdict::nothing_left);
}

TEST(Audit, ATemperatureThatHardlyMovesAboutItsReferenceIsTooWeak) {
  std::vector<testing::Run> runs = testing::one_pose();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].sheath_C = 20 + 0.001 * (i % 2 == 0 ? 1.0 : -1.0);
    runs[i].warming_C = 0;
  }
  const Audit found = audit_of(testing::records_of(runs));
  EXPECT_EQ(found.of("friction_temperature").verdict, Verdict::too_weak);
  EXPECT_GT(found.of("friction_temperature").share, 0.9);
  EXPECT_LT(found.of("friction_temperature").sigmas_at_bound, 3);
}

/// F s over the noise of each sample, less what gain and friction of the only session take, by
/// hand.
TEST(Audit, SigmasAreTheTypicalCaseOverTheNoise) {
  const auto records = testing::records_of({{.duration_s = 20}});
  const effects::ForceRecord& record = records[0];
  const effects::ForceScales scales = scales_of(records);
  NoiseModel noise = testing::usual_noise(records);
  noise.session_gain_sd = 0;
  noise.session_friction_sd = 0;
  const auto samples = static_cast<Eigen::Index>(record.samples());
  Eigen::MatrixXd common(samples, 2);
  Eigen::VectorXd preload(samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double slip = record.velocity_m_s[at] > 0 ? 1 : -1;
    const double force_N = record.output_N[at] * std::exp(testing::kMu * 3 * slip);
    common(i, 0) = force_N / noise.sample_sd_N[0][at];
    common(i, 1) = 3 * slip * force_N / noise.sample_sd_N[0][at];
    preload(i) = 0.05 * scales.larger_N() * slip / noise.sample_sd_N[0][at];
  }
  const double left = algebra::left_by(common, preload).norm();
  const Audit found = audit(records, testing::kMu, noise, 0);
  const EffectAudit& of = found.of("friction_preload");
  EXPECT_NEAR(of.sigmas, left, 1e-3 * left);
  EXPECT_NEAR(of.sigmas_at_bound, 200 * left, 0.2 * left);
  EXPECT_NEAR(of.share, left / preload.norm(), 1e-3);
}

TEST(Audit, OneSessionWithoutExcitationShowsNoneOfItsEffects) {
  auto records = testing::records_of({{.duration_s = 2}});
  effects::ForceRecord& record = records[0];
  for (auto* const channel :
       {&record.input_N, &record.output_N, &record.velocity_m_s, &record.position_m,
        &record.reversal_m, &record.rotor_rad, &record.cycle, &record.sheath_temperature_C,
        &record.winding_temperature_C}) {
    channel->assign(record.samples(), 2.0);
  }
  record.output_rate_N_s.assign(record.samples(), 0.0);
  const Audit found = audit_of(records);
  for (const EffectAudit& effect : found.effects) {
    EXPECT_FALSE(effect.visible()) << effect.effect->id;
  }
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_TRUE(found.classes.empty());
}

TEST(Audit, OfNoSessionsShowsNothing) {
  const Audit found = audit_of({});
  for (const EffectAudit& effect : found.effects) {
    EXPECT_EQ(effect.verdict, Verdict::missing_channel);
  }
}

std::vector<EffectAudit> visible_effects(std::size_t count) {
  std::vector<EffectAudit> effects(count);
  for (std::size_t i = 0; i < count; ++i) {
    effects[i].effect = effects::tension_effects()[i];
  }
  return effects;
}

TEST(Classes, AreConnectedComponents) {
  std::vector<EffectAudit> effects = visible_effects(6);
  effects[5].verdict = Verdict::nothing_left;
  const std::vector<PairAudit> pairs{{.first = 2, .second = 4, .cosine = 0.95, .experiment = "b"},
                                     {.first = 0, .second = 2, .cosine = 0.91, .experiment = "a"},
                                     {.first = 0, .second = 4, .cosine = 0.2, .experiment = "c"},
                                     {.first = 1, .second = 3, .cosine = 0.9, .experiment = "d"}};
  const std::vector<EquivalenceClass> classes = classes_of(effects, pairs);
  ASSERT_EQ(classes.size(), 3U);
  EXPECT_THAT(classes[0].members, ElementsAre(0, 2, 4));
  EXPECT_THAT(classes[0].experiments, ElementsAre("b", "a"));
  EXPECT_THAT(classes[1].members, ElementsAre(1));
  EXPECT_THAT(classes[2].members, ElementsAre(3));
}

TEST(Experiments, AreFoundWhereOnlyOneSideKnowsTheOther) {
  static constexpr effects::Separation kKnown[] = {{"silent", "do this"}};
  const effects::TensionEffect knowing{"knowing", {}, {}, {}, kKnown};
  const effects::TensionEffect silent{"silent", {}, {}, {}, {}};
  EXPECT_EQ(experiment_for(knowing, silent), "do this");
  EXPECT_EQ(experiment_for(silent, knowing), "do this");
  EXPECT_THAT(experiment_for(silent, silent), HasSubstr("cross bend angle"));
}

TEST(Experiments, ComeFromTheCatalogue) {
  const auto by_id = [](std::string_view id) { return *effects::tension_effect(id); };
  EXPECT_THAT(experiment_for(by_id("torque_ripple"), by_id("friction_position")),
              HasSubstr("several loads"));
  EXPECT_THAT(experiment_for(by_id("torque_gain"), by_id("friction_temperature")),
              HasSubstr("heat the motor alone"));
  EXPECT_THAT(experiment_for(by_id("friction_position"), by_id("friction_velocity")),
              HasSubstr("constant speeds"));
  EXPECT_THAT(experiment_for(by_id("presliding"), by_id("compliance")),
              HasSubstr("two loads and two poses"));
  EXPECT_THAT(experiment_for(by_id("bend_angle"), by_id("slack")), HasSubstr("cross"));
  EXPECT_THAT(experiment_for(by_id("filter_lag"), by_id("compliance")), Not(HasSubstr("cross ")));
}

}  // namespace
}  // namespace host_sim::diagnose
