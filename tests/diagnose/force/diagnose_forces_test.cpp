#include "host_sim/diagnose/force/diagnose_forces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/diagnose/force/findings.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

TEST(DiagnoseForces, NamesNothingWhereNothingIsHidden) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Findings findings = findings_of(measured({}, seed));
    EXPECT_THAT(ids_of(findings), IsEmpty()) << seed << ' ' << findings.prose;
  }
}

/// A joint that carries 2 N of its own and runs one way, at another speed in each session: 30 N of
/// friction and 300 N s/m.
std::vector<effects::ForceRecord> running_free(unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<effects::ForceRecord> records;
  for (int j = 0; j < 10; ++j) {
    effects::ForceRecord record;
    record.session = "s" + std::to_string(j);
    const double speed_m_s = 0.008 * (j + 1);
    for (int i = 0; i < 250; ++i) {
      const double t = 0.01 * i;
      record.time_s.push_back(t);
      record.position_m.push_back(speed_m_s * t);
      record.velocity_m_s.push_back(speed_m_s + 0.0002 * normal(engine));
      record.output_N.push_back(-2 + 0.7 * normal(engine));
      record.output_rate_N_s.push_back(0);
      record.input_N.push_back(-2 + 30 + 300 * speed_m_s + 1.5 * normal(engine));
      record.bend_angle_rad.push_back(std::numbers::pi);
      record.used.push_back(true);
      record.measured.push_back(true);
    }
    records.push_back(std::move(record));
  }
  return records;
}

/// The input is twenty times the output: no bound is by the output alone. Gain and friction are one
/// where all motion goes one way, and the gain is near 1 unless something shows that it is not.
TEST(DiagnoseForces, AJointThatRunsFreeHasFrictionAndNoOtherGain) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Findings findings = findings_of(running_free(seed));
    EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
    EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload", "friction_velocity"));
    const Estimate& preload = estimate(findings, "preload_N");
    EXPECT_LT(preload.low, 30);
    EXPECT_GT(preload.high, 30);
    EXPECT_LT(preload.high - preload.low, 100);
    EXPECT_NEAR(estimate(findings, "viscous_N_s_m").value, 300, 100);
    EXPECT_LT(metric(findings, "input_rmse_N", true), 1.15 * std::hypot(1.5, 0.7));
  }
}

/// Of 15 N of friction and 40 N s/m under no load the gain is that of the nominal model, by 0.3 in
/// its logarithm (1 standard deviation); no sensor has read 0 N throughout that could have a zero.
TEST(DiagnoseForces, ADriveWithoutLoadHasFrictionAndNoZero) {
  std::vector<effects::ForceRecord> records =
      measured({.friction = 0, .load_N = 0, .preload_N = 15, .viscous_N_s_m = 40}, 13);
  for (effects::ForceRecord& record : records) {
    std::ranges::fill(record.output_N, 0.0);
    std::ranges::fill(record.output_rate_N_s, 0.0);
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload", "friction_velocity"));
  const Estimate& preload = estimate(findings, "preload_N");
  EXPECT_NEAR(preload.value, 15, 0.5);
  EXPECT_NEAR(preload.high - preload.low, 2 * 1.96 * 0.3 * 15, 2);
  EXPECT_THAT(findings.invisible,
              Contains(testing::Field(&Invisible::why, HasSubstr("no sensor has read it"))));
  EXPECT_LT(metric(findings, "input_rmse_N", true), 1.15 * 0.5);
}

/// Friction that falls with a load of 10 to 90 N by an exponent of 0.5 is nearly a line: little of
/// it is beside 60 N that do not depend on the load, less than laws err by. Then nothing is left.
TEST(DiagnoseForces, ASmallLawBesideALargeOneIsNamedWhereNothingElseIsLeft) {
  Joint joint{
      .friction = 0.8, .load_exponent = 0.5, .still_N = 50, .preload_N = 60, .noise_N = 0.1};
  const Findings whole = findings_of(measured(joint, 3));
  EXPECT_THAT(ids_of(whole), Contains("friction_load")) << whole.prose;
  joint.cogging_N = 3;
  const Findings more = findings_of(measured(joint, 3));
  EXPECT_THAT(ids_of(more), Not(Contains("friction_load"))) << more.prose;
}

/// Friction of 6 N, four times as much in the middle of strokes of 30 and 60 mm, which both start
/// at their ends: an integral of the velocity has that 15 and 30 mm from where it begins.
TEST(DiagnoseForces, ATightPlaceIsFoundWhereOnlyTheVelocityIsKnown) {
  std::vector<effects::ForceRecord> records = measured({.noise_N = 0.2, .rotor_known = false}, 9);
  for (std::size_t j = 0; j < records.size(); ++j) {
    effects::ForceRecord& record = records[j];
    const double amplitude_m = j % 2 == 0 ? 0.015 : 0.03;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      const double from_middle_m = record.position_m[i] * amplitude_m / 0.05;
      record.position_m[i] = from_middle_m + amplitude_m;
      record.velocity_m_s[i] *= amplitude_m / 0.05;
      record.input_N[i] += 6 * (1 + 3 * std::exp(-std::pow(from_middle_m / 0.01, 2))) *
                           std::tanh(record.velocity_m_s[i] / 1e-3);
    }
    record.reversal_m = reversals_m(record);
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_position", "friction_preload"))
      << findings.prose;
  EXPECT_THAT(findings.prose, HasSubstr("from the middle of each stroke"));
  EXPECT_TRUE(std::ranges::none_of(findings.extensions, [](const auto& extension) {
    return extension.id == "friction_position";
  })) << "a controller does not know where it is";
}

/// All motion goes one way at one speed: friction of 8 N that the load does not change and a zero
/// of the load cell are one force, which gain and friction coefficient can't be for a load that
/// turns over.
TEST(DiagnoseForces, WhatIsAsGoodInThePlaceOfACauseIsACandidateToo) {
  std::vector<effects::ForceRecord> records = measured({.noise_N = 0.2}, 6);
  for (effects::ForceRecord& record : records) {
    for (std::size_t i = 0; i < record.samples(); ++i) {
      record.velocity_m_s[i] = 0.1;
      record.position_m[i] = 0.1 * record.time_s[i];
      record.input_N[i] += 8;
    }
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(findings.verdict, Verdict::ambiguous) << findings.prose;
  std::vector<std::string> ids;
  double all = 0;
  for (const Candidate& candidate : findings.candidates) {
    ids.push_back(candidate.id);
    all += candidate.probability;
  }
  EXPECT_NEAR(all, 1, 1e-12);
  // Of twelve sessions a second parameter is 1/sqrt(12) as likely as none. What is left out beside
  // each of them has a part of it.
  ASSERT_GE(ids.size(), 4U);
  EXPECT_THAT(ids[0], AnyOf("friction_preload", "load_cell_zero"));
  EXPECT_THAT(ids[1], AnyOf("friction_preload", "load_cell_zero"));
  EXPECT_NE(ids[0], ids[1]);
  EXPECT_EQ(ids[2], "friction_velocity");
  EXPECT_NEAR(findings.candidates[1].probability, findings.candidates[0].probability, 0.01);
  EXPECT_NEAR(findings.candidates[2].probability,
              findings.candidates[0].probability / std::sqrt(12), 0.05);
  // By one of them the model is right either way.
  ASSERT_EQ(findings.extensions.size(), 1U);
  EXPECT_THAT(ids, Contains(findings.extensions.front().id));
  EXPECT_LT(metric(findings, "input_rmse_N", true), 0.8);
  EXPECT_GT(metric(findings, "input_rmse_N", false), 1.5);
  EXPECT_THAT(findings.prose, HasSubstr("by which it predicts as well"));
}

/// A zero of 8 N of a drive that starts and stops each second: friction that the load does not
/// change would come on with the speed, as well it may.
TEST(DiagnoseForces, OneWayAZeroMayBeFrictionThoughTheDriveStartsAndStops) {
  std::vector<effects::ForceRecord> records =
      measured({.friction = 0, .noise_N = 0.2, .gain_scatter = 0.002}, 6);
  for (effects::ForceRecord& record : records) {
    for (std::size_t i = 0; i < record.samples(); ++i) {
      record.velocity_m_s[i] = 0.1 * std::pow(std::sin(std::numbers::pi * record.time_s[i]), 2);
      record.position_m[i] = i == 0 ? 0 : record.position_m[i - 1] + 0.01 * record.velocity_m_s[i];
      record.input_N[i] += 8;
    }
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(findings.verdict, Verdict::ambiguous) << findings.prose;
  EXPECT_THAT(findings.equivalent_sets,
              Contains(UnorderedElementsAre("friction_preload", "load_cell_zero")));
}

/// A tendon that pulls 25 .. 55 N over a drum or a pulley, by its own equations.
struct Tendon {
  double log_ratio = 0.3;  ///< mu phi
  double stiffness_N_m = 1000;
  double input_noise_N = 0.2;
  double output_noise_N = 0.1;
};

std::vector<effects::ForceRecord> pulled(const Tendon& tendon, unsigned seed) {
  std::vector<effects::ForceRecord> records =
      measured({.load_N = 15, .still_N = 40, .noise_N = tendon.output_noise_N}, seed);
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0, tendon.input_noise_N);
  for (std::size_t j = 0; j < records.size(); ++j) {
    effects::ForceRecord& record = records[j];
    record.pulls_alone = true;
    const double omega = 2 * std::numbers::pi * (0.3 + 0.1 * static_cast<double>(j));
    double z = 0;
    double before_m = 0;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      constexpr int kParts = 20;
      const double full_N = record.output_N[i] * std::expm1(tendon.log_ratio);
      for (int part = 1; part <= kParts && i > 0; ++part) {
        const double x = 0.05 * std::sin(omega * (record.time_s[i] - 0.01 + 0.01 * part / kParts));
        const double side = x > before_m ? 1 : -1;
        z = side + (z - side) * std::exp(-std::abs(x - before_m) * tendon.stiffness_N_m / full_N);
        before_m = x;
      }
      record.input_N[i] = record.output_N[i] * std::exp(tendon.log_ratio * z) + noise(engine);
    }
  }
  return records;
}

/// Friction of 2 % turns over in 16 mm of 100 mm: k is an eighth of the force over the stroke.
TEST(DiagnoseForces, NamesPreslidingOfATendonThatIsNearlyFree) {
  const Findings findings = findings_of(pulled(
      {.log_ratio = 0.02, .stiffness_N_m = 50, .input_noise_N = 0.04, .output_noise_N = 0.02}, 7));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("presliding"));
  EXPECT_NEAR(estimate(findings, "presliding_stiffness_N_m").value, 50, 4);
  const double input_N = metric(findings, "input_rmse_N", true);
  EXPECT_NEAR(metric(findings, "rmse_N", true), input_N, 0.1 * input_N);
}

/// A model that is written has presliding over a length that is always the same: near that of 40 N.
TEST(DiagnoseForces, WhereNoModelHoldsALawItHoldsAnotherOfTheSameEffect) {
  const Findings findings = findings_of(pulled({}, 7));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("presliding"));
  EXPECT_NEAR(estimate(findings, "presliding_stiffness_N_m").value, 1000, 50);
  ASSERT_FALSE(findings.extensions.empty());
  EXPECT_EQ(findings.extensions.front().id, "presliding");
  EXPECT_NEAR(value_of(findings.extensions.front(), "presliding_length_m"), 0.014, 0.004);
}

TEST(DiagnoseForces, NamesLoadIndependentAndViscousFrictionOfASignedForce) {
  const Findings findings = findings_of(measured({.preload_N = 12, .viscous_N_s_m = 150}, 3));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload", "friction_velocity"));
  EXPECT_NEAR(estimate(findings, "preload_N").value, 12, 0.6);
  EXPECT_NEAR(estimate(findings, "viscous_N_s_m").value, 150, 8);
  // The noise of both ends is what is left.
  EXPECT_LT(metric(findings, "input_rmse_N", true), 1.0);
  EXPECT_GT(metric(findings, "input_rmse_N", false), 8);
  ASSERT_TRUE(findings.remainder);
  EXPECT_LT(findings.remainder->share, 0.02);
  EXPECT_DOUBLE_EQ(findings.remainder->input_rmse_N, metric(findings, "input_rmse_N", true));
}

TEST(DiagnoseForces, ACauseIsDrawnWithoutAndWithIt) {
  const TensionDiagnosis diagnosis =
      diagnose_forces(measured({.preload_N = 12}, 6), nominal(), kWire, {});
  ASSERT_EQ(diagnosis.causes.size(), 1U);
  EXPECT_EQ(diagnosis.causes[0].id, "friction_preload");
  const TracePicture& trace = diagnosis.causes[0].trace;
  const auto off_N = [&trace](const std::vector<double>& model_N) {
    double square_N2 = 0;
    for (std::size_t i = 0; i < model_N.size(); ++i) {
      square_N2 += std::pow(trace.measured_N[i] - model_N[i], 2);
    }
    return std::sqrt(square_N2 / static_cast<double>(model_N.size()));
  };
  // Friction of 12 N against the motion that a gain and a friction coefficient stand in for; with
  // it the noise of both ends is left.
  EXPECT_GT(off_N(trace.before_N), 4);
  EXPECT_LT(off_N(trace.after_N), 1.5);
}

/// 5 N of load, and a zero that is four times as much: all that drives the joint is off by it.
TEST(DiagnoseForces, AZeroMayBeLargerThanTheLoad) {
  const Findings findings =
      findings_of(measured({.load_N = 7, .offset_N = 20, .preload_N = 15}, 11));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload", "load_cell_zero"));
  EXPECT_NEAR(estimate(findings, "load_cell_zero_N").value, -20, 1);
}

/// Of five sessions of 0.8 s that run more one way than the other, a zero of 1 N scatters what
/// friction of 3 N takes off so much that it is not seen without it. Five are too few to name them.
TEST(DiagnoseForces, TwoCausesThatHideEachOtherComeInTogether) {
  std::vector<effects::ForceRecord> records =
      measured({.offset_N = 1, .preload_N = 3, .noise_N = 1}, 4, 5);
  for (effects::ForceRecord& record : records) {
    std::fill(record.used.begin() + 80, record.used.end(), false);
  }
  std::vector<std::string> added;
  for (const Step& step : findings_of(records).steps) {
    added.push_back(step.effect.id);
  }
  EXPECT_THAT(added, ElementsAre("", "friction_preload", "load_cell_zero"));
}

/// Under a load that hardly changes, friction that does not depend on it is also one that falls as
/// it rises, by all that the bounds allow.
TEST(DiagnoseForces, FrictionUnderAStillLoadIsNotLostBetweenTwoOfItsLaws) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Findings findings = findings_of(measured(
        {.friction = 0, .load_N = 30, .still_N = 150, .gain = 1.3, .preload_N = 60}, seed));
    EXPECT_THAT(findings.verdict, AnyOf(Verdict::named, Verdict::ambiguous)) << findings.prose;
  }
}

/// 30 N, and 1 N that a load of 250 N adds: a law of the load that hardly lets it rise is no other
/// one.
TEST(DiagnoseForces, FrictionThatTheLoadDoesNotChangeIsLoadIndependent) {
  const Findings findings = findings_of(measured(
      {.friction = 0.005, .load_N = 100, .still_N = 250, .preload_N = 30, .noise_N = 5}, 12));
  EXPECT_EQ(findings.verdict, Verdict::named) << findings.prose;
  EXPECT_THAT(ids_of(findings), UnorderedElementsAre("friction_preload"));
}

TEST(DiagnoseForces, FrictionOfTheLoadIsNotASheathThatGives) {
  Joint joint{.friction = 0.2, .load_exponent = 0.3, .noise_N = 0.1, .gain_scatter = 0.002};
  const Findings falling = findings_of(measured(joint, 9));
  EXPECT_EQ(falling.verdict, Verdict::named) << falling.prose;
  EXPECT_THAT(ids_of(falling), UnorderedElementsAre("friction_load"));
  joint.load_exponent = 0;
  joint.giving = -0.3;
  const TensionDiagnosis giving = diagnose_forces(measured(joint, 9), nominal(), kWire, {});
  EXPECT_EQ(giving.findings.verdict, Verdict::unknown) << giving.findings.prose;
  EXPECT_THAT(ids_of(giving.findings), IsEmpty());
  EXPECT_THAT(giving.findings.prose, HasSubstr("looks like load-dependent friction"));
  EXPECT_EQ(giving.findings.candidates.front().id, "unknown");
  EXPECT_THAT(giving.findings.prose, HasSubstr("a sheath that bends more or less under load"));
}

/// Friction of 2 .. 6 N that is 40 % larger one way and as much less the other is off by 1.4 N both
/// ways, as by a zero, but for where the motion turns over.
TEST(DiagnoseForces, FrictionThatIsLargerOneWayIsNoZero) {
  const Joint joint{.friction = 0.1, .preload_N = 2, .one_way = 0.4, .noise_N = 0.2};
  const TensionDiagnosis diagnosis = diagnose_forces(measured(joint, 11), nominal(), kWire, {});
  EXPECT_THAT(ids_of(diagnosis.findings), Not(Contains("load_cell_zero")))
      << diagnosis.findings.prose;
  EXPECT_THAT(diagnosis.findings.prose, HasSubstr("looks like zero of the output sensor"));
}

/// The top of a sine of 40 N is read a tenth too small.
TEST(DiagnoseForces, ASensorThatIsNotLinearIsNoFriction) {
  std::vector<effects::ForceRecord> records =
      measured({.friction = 0.2, .noise_N = 0.1, .gain_scatter = 0.002}, 10);
  for (effects::ForceRecord& record : records) {
    record.pulls_alone = true;
    for (std::size_t i = 0; i < record.samples(); ++i) {
      record.used[i] = record.output_N[i] > 2;
      record.output_N[i] *= 1 - 0.1 * record.output_N[i] * record.output_N[i] / 1600;
    }
  }
  const TensionDiagnosis diagnosis = diagnose_forces(records, nominal(), kWire, {});
  EXPECT_NE(diagnosis.findings.verdict, Verdict::named) << diagnosis.findings.prose;
  EXPECT_THAT(diagnosis.findings.prose, HasSubstr("What looks like"));
  EXPECT_THAT(diagnosis.findings.prose, HasSubstr("a sensor of the output that is not linear"));
}

/// A spring that the catalogue does not have leaves nearly as much as the zero takes off: friction
/// would have to take more, as its laws are like each other.
TEST(DiagnoseForces, AZeroOfATendonThatPullsAloneIsNamedAlthoughMoreIsWrong) {
  const auto pulled_alone = [](double offset_N) {
    std::vector<effects::ForceRecord> records = measured({.friction = 0.2,
                                                          .load_N = 40,
                                                          .still_N = 50,
                                                          .offset_N = offset_N,
                                                          .noise_N = 1,
                                                          .spring_N = 0.6},
                                                         21, 24);
    for (effects::ForceRecord& record : records) {
      record.pulls_alone = true;
    }
    return records;
  };
  EXPECT_THAT(ids_of(findings_of(pulled_alone(1.2))), ElementsAre("load_cell_zero"));
  EXPECT_THAT(ids_of(findings_of(pulled_alone(0.7))), IsEmpty());
}

TEST(DiagnoseForces, AZeroOfWhatWorksBothWaysIsNamedAlthoughMoreIsWrong) {
  const auto found_with = [](double offset_N) {
    return findings_of(
        measured({.friction = 0.2, .offset_N = offset_N, .noise_N = 1, .spring_N = 2.5}, 21));
  };
  EXPECT_THAT(ids_of(found_with(0.9)), ElementsAre("load_cell_zero"));
  EXPECT_THAT(ids_of(found_with(0.6)), IsEmpty());
}

TEST(DiagnoseForces, AFewSessionsNameNothing) {
  const Findings findings = findings_of(measured({.preload_N = 12}, 5, 3));
  EXPECT_THAT(ids_of(findings), IsEmpty());
  EXPECT_THAT(findings.prose, HasSubstr("It takes 4 sessions to name anything (here: 3)"));
}

TEST(DiagnoseForces, NothingIsNamedBesideADoubtThatSpoilsIt) {
  const Findings sound = findings_of(measured({.preload_N = 12}, 6));
  EXPECT_THAT(ids_of(sound), Contains("friction_preload"));
  EXPECT_THAT(sound.doubts, IsEmpty());
  const Findings reversed = findings_of(measured({.preload_N = 12, .velocity_reversed = true}, 6));
  EXPECT_EQ(reversed.verdict, Verdict::unknown);
  EXPECT_THAT(reversed.effects, IsEmpty());
  EXPECT_THAT(reversed.extensions, IsEmpty());
  ASSERT_EQ(reversed.doubts.size(), 1U);
  EXPECT_TRUE(reversed.doubts[0].spoils);
}

TEST(DiagnoseForces, ASessionThatADoubtSpoilsIsLeftOut) {
  std::vector<effects::ForceRecord> records = measured({.preload_N = 12}, 6);
  for (double& velocity_m_s : records[4].velocity_m_s) {
    velocity_m_s = -velocity_m_s;
  }
  const Findings findings = findings_of(records);
  EXPECT_EQ(ids_of(findings), ids_of(findings_of(measured({.preload_N = 12}, 6))));
  ASSERT_EQ(findings.doubts.size(), 1U);
  EXPECT_THAT(findings.doubts[0].sessions, ElementsAre("s4"));
}

TEST(DiagnoseForces, WhatIsTakenOutOfTheCatalogueIsNotNamed) {
  DiagnoseOptions options;
  options.without = {"friction_preload"};
  EXPECT_THAT(
      ids_of(diagnose_forces(measured({.preload_N = 12}, 6), nominal(), kWire, options).findings),
      Not(Contains("friction_preload")));
}

/// A stroke to and fro is as fast at a place as it always is there: friction of 12 N that falls by
/// a third as a joint speeds up is no friction of places, and no viscous one.
TEST(DiagnoseForces, FrictionByTheSpeedIsNotThatOfPlaces) {
  std::vector<effects::ForceRecord> records = measured({.noise_N = 0.3, .gain_scatter = 0.002}, 6);
  std::mt19937 engine(6);
  std::normal_distribution<double> noise_N(0, 0.3);
  const double omega = 2 * std::numbers::pi * 0.5;
  for (effects::ForceRecord& record : records) {
    for (std::size_t i = 0; i < record.samples(); ++i) {
      const double v = std::cos(omega * record.time_s[i]);
      record.position_m[i] = 0.05 * std::sin(omega * record.time_s[i]);
      record.velocity_m_s[i] = 0.05 * omega * v;
      record.input_N[i] = record.output_N[i] +
                          12 * (1 - std::abs(v) / 3) * std::tanh(record.velocity_m_s[i] / 1e-3) +
                          noise_N(engine);
    }
    record.reversal_m = effects::reversals_m(record);
  }
  const Findings findings = findings_of(records);
  EXPECT_THAT(ids_of(findings), Not(Contains("friction_position"))) << findings.prose;
  EXPECT_THAT(findings.prose, HasSubstr("friction that depends on the speed in a way of its own"));
}

TEST(DiagnoseForces, TheNumberOfThreadsDoesNotMatter) {
  const std::vector<effects::ForceRecord> records = measured({.preload_N = 12}, 7);
  const auto by = [&](unsigned threads) {
    DiagnoseOptions options;
    options.threads = threads;
    return diagnose_forces(records, nominal(), kWire, options).findings;
  };
  EXPECT_EQ(estimate(by(1), "preload_N").value, estimate(by(3), "preload_N").value);
  EXPECT_EQ(by(1).prose, by(3).prose);
}

}  // namespace
}  // namespace host_sim::diagnose
