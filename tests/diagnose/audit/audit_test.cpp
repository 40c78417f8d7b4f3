#include "host_sim/diagnose/audit/audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "tests/diagnose/audit/sessions.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Verdict = EffectAudit::Verdict;

Audit audit_of(const std::vector<Session>& sessions, const NoiseModel& noise = {}) {
  return audit(gram_of(sessions, {.baseline = testing::baseline()}), noise);
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
  const Audit found = audit_of(testing::sessions_of(testing::one_pose()));
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
  const Audit found = audit_of(testing::sessions_of(warming_with_cycles()));
  const PairAudit* pair = found.pair("friction_wear", "friction_temperature");
  ASSERT_NE(pair, nullptr);
  EXPECT_GT(pair->cosine, 0.95);
  EXPECT_THAT(pair->experiment, HasSubstr("heat the sheath alone"));
  EXPECT_THAT(found.prose,
              HasSubstr("friction_temperature, friction_wear cannot be distinguished"));
}

/// |cos| of the two columns in nine values, one a session, by least squares written out: with a
/// scatter between sessions far above the noise of samples, that is all that is left. At one pose
/// what is refitted is the mean.
TEST(Audit, CosineIsThatOfTheSessionMeansWhereScatterRules) {
  std::vector<testing::Run> runs = testing::one_pose();
  Eigen::VectorXd wear(9);
  Eigen::VectorXd temperature(9);
  for (Eigen::Index i = 0; i < 9; ++i) {
    testing::Run& run = runs[static_cast<std::size_t>(i)];
    run.sheath_C = 25 + static_cast<double>((i * i) % 7) + 2.0 * static_cast<double>(i);
    run.warming_C = 0;
    wear(i) = run.start_cycle;
    temperature(i) = run.sheath_C;
  }
  wear.array() -= wear.mean();
  temperature.array() -= temperature.mean();
  const double expected = std::abs(wear.dot(temperature)) / (wear.norm() * temperature.norm());
  std::vector<Session> sessions = testing::sessions_of(runs);
  for (Session& session : sessions) {
    for (double& cycle : session.covariates.cycle) {
      cycle = session.covariates.cycle.front();
    }
  }
  const Grams grams = gram_of(sessions, {.baseline = testing::baseline()});
  const Projection projection =
      project(grams, {.sample_sd = 1e-3, .session_gain_sd = 1, .session_friction_sd = 1});
  const auto column = [&](std::string_view id, std::size_t block) {
    return static_cast<Eigen::Index>(grams.layout.of(id).blocks[block].first);
  };
  const Eigen::Index a = column("friction_wear", 3);  // exponent 1
  const Eigen::Index b = column("friction_temperature", 0);
  const double found =
      std::abs(projection.left(a, b)) / std::sqrt(projection.left(a, a) * projection.left(b, b));
  EXPECT_NEAR(found, expected, 1e-4);
}

TEST(Audit, ACrossedDesignTellsAllEffectsApart) {
  const Audit found = audit_of(testing::sessions_of(testing::crossed()));
  for (const EffectAudit& effect : found.effects) {
    EXPECT_TRUE(effect.visible()) << effect.effect->id() << ": " << effect.prose;
    EXPECT_THAT(effect.prose, HasSubstr("standard deviations"));
  }
  EXPECT_EQ(found.pairs.size(), found.effects.size() * (found.effects.size() - 1) / 2);
  for (const PairAudit& pair : found.pairs) {
    EXPECT_LE(pair.cosine, 0.9) << found.effects[pair.first].effect->id() << ' '
                                << found.effects[pair.second].effect->id();
    EXPECT_LE(pair.cosine, pair.canonical + 1e-9);
    EXPECT_FALSE(pair.experiment.empty());
  }
  for (const EquivalenceClass& alone : found.classes) {
    EXPECT_EQ(alone.members.size(), 1U);
    EXPECT_TRUE(alone.experiments.empty());
  }
  EXPECT_EQ(found.prose, "");
}

TEST(Audit, AnAsymmetryIsAMemberOfTheBendAngleErrorsButNotTheirEqual) {
  const Audit found = audit_of(testing::sessions_of(testing::crossed()));
  const PairAudit* pair = found.pair("bend_angle", "gear_asymmetry");
  ASSERT_NE(pair, nullptr);
  EXPECT_NEAR(pair->canonical, 1, 1e-6);
  EXPECT_LT(pair->cosine, 0.9);
}

TEST(Audit, AMissingChannelIsSaidWithItsName) {
  std::vector<Session> sessions = testing::sessions_of(testing::one_pose());
  sessions[4].covariates.winding_temperature_C.clear();
  const Audit found = audit_of(sessions);
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
  EXPECT_EQ(audit_of(testing::sessions_of(runs)).of("friction_temperature").verdict,
            Verdict::nothing_left);
}

TEST(Audit, ATemperatureThatHardlyMovesAboutItsReferenceIsTooWeak) {
  std::vector<testing::Run> runs = testing::one_pose();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].sheath_C = 20 + 0.001 * (i % 2 == 0 ? 1.0 : -1.0);
    runs[i].warming_C = 0;
  }
  const Audit found = audit_of(testing::sessions_of(runs));
  EXPECT_EQ(found.of("friction_temperature").verdict, Verdict::too_weak);
  EXPECT_GT(found.of("friction_temperature").share, 0.9);
  EXPECT_LT(found.of("friction_temperature").sigmas_at_bound, 3);
}

/// What of a signature is left beside gain and friction of one session at one pose.
double left_of(const Eigen::VectorXd& signature, const recording::Covariates& c) {
  Eigen::MatrixXd common(signature.size(), 2);
  for (Eigen::Index i = 0; i < signature.size(); ++i) {
    common(i, 0) = 1;
    common(i, 1) = c.direction[static_cast<std::size_t>(i)];
  }
  return algebra::left_by(common, signature).norm();
}

/// -2 sinh(r/2) = F s/T where a force F acts, by hand.
Eigen::VectorXd preload_signature(const recording::Covariates& c, double force_N) {
  Eigen::VectorXd signature(static_cast<Eigen::Index>(c.samples()));
  for (Eigen::Index i = 0; i < signature.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    signature(i) = -2 * std::asinh(force_N * c.direction[at] / c.current_tension_N[at] / 2);
  }
  return signature;
}

TEST(Audit, SigmasAreTheTypicalSignatureOverTheNoise) {
  const std::vector<Session> sessions = testing::sessions_of({{.duration_s = 20}});
  const recording::Covariates& c = sessions[0].covariates;
  const Audit found =
      audit_of(sessions, {.sample_sd = 0.03, .session_gain_sd = 0, .session_friction_sd = 0});
  // 2.5 N is the shape next to the usual 2 N; 40 N, of which twice as much may be, shows best.
  const Eigen::VectorXd usual = preload_signature(c, 2.5);
  const Eigen::VectorXd largest = preload_signature(c, 40);
  const EffectAudit& preload = found.of("friction_preload");
  EXPECT_NEAR(preload.sigmas, left_of(usual, c) / 0.03, 1e-6);
  EXPECT_NEAR(preload.sigmas_at_bound, 2 * left_of(largest, c) / 0.03, 1e-4);
  EXPECT_NEAR(preload.share, left_of(largest, c) / largest.norm(), 1e-9);
}

TEST(Audit, OneSessionWithoutExcitationShowsNoneOfItsEffects) {
  std::vector<Session> sessions = testing::sessions_of({{.duration_s = 2}});
  recording::Covariates& c = sessions[0].covariates;
  for (std::vector<double>* channel :
       {&c.current_A, &c.current_tension_N, &c.output_tension_N, &c.velocity_m_s, &c.position_m,
        &c.motor_angle_rad, &c.cycle, &c.sheath_temperature_C, &c.winding_temperature_C}) {
    channel->assign(c.samples(), 2.0);
  }
  c.direction.assign(c.samples(), 1.0);
  c.log_tension_rate_1_s.assign(c.samples(), 0.0);
  c.log_output_rate_1_s.assign(c.samples(), 0.0);
  const Audit found = audit_of(sessions);
  for (const EffectAudit& effect : found.effects) {
    EXPECT_FALSE(effect.visible()) << effect.effect->id();
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
    effects[i].effect = effects::tension_effects()[i].get();
  }
  return effects;
}

TEST(Classes, AreConnectedComponents) {
  std::vector<EffectAudit> effects = visible_effects(6);
  effects[5].verdict = Verdict::nothing_left;
  const std::vector<PairAudit> pairs{
      {.first = 2, .second = 4, .cosine = 0.95, .canonical = 1, .experiment = "b"},
      {.first = 0, .second = 2, .cosine = 0.91, .canonical = 1, .experiment = "a"},
      {.first = 0, .second = 4, .cosine = 0.2, .canonical = 1, .experiment = "c"},
      {.first = 1, .second = 3, .cosine = 0.9, .canonical = 1, .experiment = "d"}};
  const std::vector<EquivalenceClass> classes = classes_of(effects, pairs);
  ASSERT_EQ(classes.size(), 3U);
  EXPECT_THAT(classes[0].members, ElementsAre(0, 2, 4));
  EXPECT_THAT(classes[0].experiments, ElementsAre("b", "a"));
  EXPECT_THAT(classes[1].members, ElementsAre(1));
  EXPECT_THAT(classes[2].members, ElementsAre(3));
}

/// An effect of which only the id and what separates it is ever asked.
class Stub final : public effects::TensionEffect {
 public:
  Stub(std::string_view id, std::span<const effects::Separation> separations)
      : id_(id), separations_(separations) {}
  std::string_view id() const override { return id_; }
  std::string_view term() const override { return {}; }
  std::string_view equation() const override { return {}; }
  std::string_view life_consequence() const override { return {}; }
  std::span<const effects::Parameter> parameters() const override { return {}; }
  std::span<const effects::Separation> separations() const override { return separations_; }
  std::string missing(const recording::Covariates&) const override { return {}; }
  std::vector<std::vector<double>> shapes() const override { return {}; }
  effects::Signature signature(const recording::Covariates&, const effects::Baseline&,
                               std::span<const double>) const override {
    return {};
  }

 private:
  std::string_view id_;
  std::span<const effects::Separation> separations_;
};

TEST(Experiments, AreFoundWhereOnlyOneSideKnowsTheOther) {
  constexpr effects::Separation kKnown[] = {{"silent", "do this"}};
  const Stub knowing("knowing", kKnown);
  const Stub silent("silent", {});
  EXPECT_EQ(experiment_for(knowing, silent), "do this");
  EXPECT_EQ(experiment_for(silent, knowing), "do this");
  EXPECT_THAT(experiment_for(silent, silent), HasSubstr("cross bend angle"));
}

TEST(Experiments, ComeFromTheCatalogue) {
  const auto by_id = [](std::string_view id) -> const effects::TensionEffect& {
    for (const auto& effect : effects::tension_effects()) {
      if (effect->id() == id) {
        return *effect;
      }
    }
    throw std::out_of_range("no such effect");
  };
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
