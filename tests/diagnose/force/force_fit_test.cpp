#include "host_sim/diagnose/force/force_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "host_sim/diagnose/force/force_covariates.hpp"
#include "host_sim/diagnose/force/judgement.hpp"
#include "host_sim/diagnose/force/paired_gain.hpp"
#include "host_sim/statistics/distribution.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

/// A joint of a stroke of 0.1 m whose friction comes 0.1 .. 7 mm after each reversal.
ForceData with_slack(double slack_m, unsigned seed, double noise_N = 0.2) {
  std::vector<effects::ForceRecord> records = measured({.noise_N = 0.01}, seed);
  const effects::ForceScales scales = scales_of(records);
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0, noise_N);
  for (effects::ForceRecord& record : records) {
    predict_input(record, kinematics_of(record, scales), {effects::ForceTerm::slack}, scales,
                  std::vector<double>{1, 0.1, slack_m}, record.input_N);
    for (double& input_N : record.input_N) {
      input_N += noise(engine);
    }
  }
  return ForceData(std::move(records));
}

class Slack : public testing::TestWithParam<double> {};

/// Samples are up to 0.05 m * 2 pi * 1.4 Hz * 0.01 s = 4.4 mm apart, of which all reversals know a
/// small part.
TEST_P(Slack, IsFoundBetweenSamples) {
  int inside = 0;
  constexpr int kTimes = 4;
  for (unsigned seed = 1; seed <= kTimes; ++seed) {
    const ForceData data = with_slack(GetParam(), seed);
    const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
    const ForceFit fit =
        data.finished(data.started(nominal, std::array{effects::ForceTerm::slack}, 1).front());
    const double half_m = data.half_widths(fit).at(2);
    const double found_m = fit.parameters.at(2);
    EXPECT_NEAR(found_m, GetParam(), 4 * half_m);
    EXPECT_GT(half_m, 2e-5);
    EXPECT_LT(half_m, 2e-3);
    inside += std::abs(found_m - GetParam()) < half_m ? 1 : 0;
  }
  EXPECT_GE(inside, kTimes - 1);
}

INSTANTIATE_TEST_SUITE_P(Lengths, Slack, testing::Values(0.0007, 0.002, 0.007, 0.02));

/// Whatever the sessions of a fold hold, its fit never saw it: from the same start it ends the
/// same, and those of the other folds do not.
TEST(ForceData, AFoldNeverSawItsSessions) {
  constexpr std::size_t kFold = 2;
  std::vector<effects::ForceRecord> records = measured({.preload_N = 12}, 6);
  const ForceData data(records);
  const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
  const ForceFit start = data.with(nominal, effects::ForceTerm::preload, 1);
  const auto before = data.fold_fits(std::array{nominal, start}, 2);
  for (std::size_t j = kFold; j < records.size(); j += ForceData::kFolds) {
    for (double& input_N : records[j].input_N) {
      input_N *= 1.1;
    }
  }
  const auto after = ForceData(records).fold_fits(std::array{nominal, start}, 2);
  ASSERT_EQ(after.size(), 2U);
  for (std::size_t model = 0; model < 2; ++model) {
    ASSERT_EQ(after[model].size(), 5U);
    const auto moved = [&](std::size_t fold) {
      return std::abs(after[model][fold].parameters[0] - before[model][fold].parameters[0]);
    };
    for (const std::size_t other : {0U, 1U, 3U, 4U}) {
      // What is known of the gain, and the steps of derivatives, go with the forces of all.
      EXPECT_LT(moved(kFold), 0.02 * moved(other)) << model << ' ' << other;
    }
  }
}

/// Friction of 60 N turns over by 0.05 of the speed, beside 400 N that the gain is 30 % off of.
TEST(ForceData, HowSharpFrictionTurnsOverIsSeenBesideAGainThatIsOff) {
  const ForceData data(
      measured({.still_N = 400, .gain = 1.3, .turn_over_m_s = 0.015, .preload_N = 60}, 5));
  EXPECT_NEAR(data.scales().speed_m_s, 0.3, 0.05);
  EXPECT_DOUBLE_EQ(data.scales().turn_over_m_s, 0.05 * data.scales().speed_m_s);
}

/// Filters of both forces have friction follow the motion by 8 ms, less than a sample of 10 ms.
TEST(ForceData, HowLateFrictionTurnsOverIsSeen) {
  const auto late_of_s = [](double late_s) {
    return ForceData(measured({.preload_N = 12, .noise_N = 0.1, .late_s = late_s}, 4))
        .scales()
        .forces_late_s;
  };
  EXPECT_NEAR(late_of_s(0.008), 0.008, 0.0015);
  EXPECT_DOUBLE_EQ(late_of_s(0), 0);
}

/// Each sample has what the filters make of all that was read, also of what is not kept.
TEST(ForceData, WhatIsKeptIsAsLateAsWhatWasRead) {
  const Joint joint{.preload_N = 12, .noise_N = 0.1, .late_s = 0.006, .samples = 2400};
  const ForceData data(measured(joint, 4));
  EXPECT_LT(data.records().front().samples(), 1250U);
  EXPECT_NEAR(data.scales().forces_late_s, 0.006, 0.001);
  const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
  const ForceFit preload = data.with(nominal, effects::ForceTerm::preload, 1);
  EXPECT_LT(data.rmse_N(data.mean_squares_N2(data.residuals_N(preload))), 0.6);
}

TEST(ForceData, WhatTheTruthTakesOffIsAllThatIsThere) {
  const ForceData data = with_slack(0.007, 5, 0.02);
  const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
  const HeldOut without = data.held_out(nominal);
  const HeldOut with = data.held_out(
      data.finished(data.started(nominal, std::array{effects::ForceTerm::slack}, 1).front()));
  const PairedGain gain = paired_gain(data, without, with, false);
  EXPECT_NEAR(gain.slope, 1, 0.05);
  EXPECT_LT(gain.error, 0.05);
  EXPECT_GT(gain.log_odds, 10);
  EXPECT_NEAR(paired_gain(data, with, without, false).slope, 0, 0.05);
}

/// Friction that comes 1 mm after each reversal seems to turn over slowly, until what keeps it is
/// in the model.
TEST(ForceData, HowSharpFrictionTurnsOverIsSettledAnewBesideSlack) {
  ForceData data = with_slack(0.001, 3, 0.02);
  const double speed_m_s = data.scales().speed_m_s;
  EXPECT_DOUBLE_EQ(data.scales().turn_over_m_s, 0.15 * speed_m_s);
  const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
  data.settle_turn_over(nominal);
  EXPECT_DOUBLE_EQ(data.scales().turn_over_m_s, 0.15 * speed_m_s);
  data.settle_turn_over(
      data.finished(data.started(nominal, std::array{effects::ForceTerm::slack}, 1).front()));
  EXPECT_DOUBLE_EQ(data.scales().turn_over_m_s, 0.05 * speed_m_s);
}

/// Of white noise a gain of 1/2 leaves a quarter, and the mean of two samples a half.
TEST(ForceData, AModelPassesOnNoiseOfTheOutput) {
  const ForceData data(measured({.friction = 0}, 9));
  const ForceFit all{{}, {1, 0}, 0};
  const double three_quarters_N2 = data.noise_taken_N2(all, {{}, {0.5, 0}, 0});
  EXPECT_GT(three_quarters_N2, 0);
  EXPECT_NEAR(data.noise_taken_N2(all, {{effects::ForceTerm::delay}, {1, 0, 0.005}, 0}),
              0.5 / 0.75 * three_quarters_N2, 0.05 * three_quarters_N2);
  EXPECT_EQ(data.noise_taken_N2(all, all), 0);
}

/// Friction of 12 N is 120 N for a unit of a coefficient of 0.1, one way and the other.
TEST(ForceData, FrictionOfASessionIsAShareOfWhatRubsByTheModel) {
  const ForceData data(measured({.preload_N = 12}, 4));
  const effects::ForceRecord& record = data.records()[2];
  const Eigen::MatrixX2d directions_N =
      data.directions_N(2, {{effects::ForceTerm::preload}, {1, 0, 12}, 0}, 0.1);
  for (std::size_t i = 0; i < record.samples(); ++i) {
    const double slip = record.used[i] ? data.kinematics()[2].turned_over[i] : 0;
    const double output_N = record.used[i] ? record.output_N[i] : 0;
    const auto at = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(directions_N(at, 0), output_N + 12 * slip, 1e-9);
    EXPECT_NEAR(directions_N(at, 1), 120 * slip, 1e-6);
  }
}

/// exp(mu phi) of a coefficient that is none: T phi, of half a turn.
TEST(ForceData, FrictionOfASessionIsAsTheSheathHasItWhereNothingRubs) {
  const ForceData data(measured({.friction = 0}, 4));
  const effects::ForceRecord& record = data.records()[2];
  const Eigen::MatrixX2d directions_N = data.directions_N(2, {{}, {1, 0}, 0}, 0);
  for (std::size_t i = 0; i < record.samples(); ++i) {
    const double slip = record.used[i] ? data.kinematics()[2].turned_over[i] : 0;
    const double expected_N = std::abs(record.output_N[i]) * record.bend_angle_rad[i] * slip;
    EXPECT_NEAR(directions_N(static_cast<Eigen::Index>(i), 1), expected_N, 1e-4);
  }
}

/// Sheaths of sessions differ by as much of any load.
TEST(ForceData, FrictionOfASessionIsInProportionToTheLoadWhereThatOfTheModelIsNot) {
  const ForceData data(measured({}, 4));
  const Eigen::MatrixX2d even = data.directions_N(2, {{}, {1, 0.02}, 0}, 0.1);
  const Eigen::MatrixX2d falling =
      data.directions_N(2, {{effects::ForceTerm::load}, {1, 0.02, 0.5}, 0}, 0.1);
  EXPECT_GT(even.col(1).norm(), 0);
  EXPECT_LT((falling.col(1) - even.col(1)).norm(), 1e-6 * even.col(1).norm());
}

/// One session of twelve says by 8 N^2 of its own that it is worse, and the others say nothing: the
/// mean of 2/3 is as large as its standard error.
TEST(ForceData, OneSessionThatIsWorseIsNoCertainLoss) {
  const ForceData data(measured({}, 4));
  HeldOut before;
  before.plain_N2.assign(12, 2);
  before.weighted_N2 = before.beside_scatter_N2 = before.plain_N2;
  before.residuals_N.assign(12, std::vector<double>(500, 1));
  HeldOut after = before;
  after.plain_N2[3] = 10;
  const PairedGain gain = paired_gain(data, before, after, true);
  EXPECT_NEAR(gain.plain_N2, -8.0 / 12, 1e-9);
  EXPECT_NEAR(gain.plain_error_N2, 8.0 / 12, 1e-9);
}

/// By a square that is larger by 5 % an effect stays, and not by 20 %, though sessions scatter by
/// as much as there is.
TEST(Judgement, AnEffectBesideWhichTheErrorIsLargerDoesNotStay) {
  const ForceData data(measured({.preload_N = 6}, 5));
  const ForceFit nominal = data.fit({}, {1, 0.1}, ForceData::kIterations);
  const ForceFit model = data.with(nominal, effects::ForceTerm::preload, 1);
  const HeldOut held = data.held_out(model);
  const HeldOut held_without = data.held_out(nominal);
  const double left_N2 = std::pow(data.rmse_N(held.plain_N2), 2);
  const auto stays = [&](double worse) {
    PairedGain gain = paired_gain(data, held_without, held, true);
    gain.plain_N2 = -worse * left_N2;
    gain.plain_error_N2 = left_N2;
    const std::vector<Judged> judged{{.term = effects::ForceTerm::preload,
                                      .gain = gain,
                                      .without = nominal,
                                      .held_without = held_without}};
    const Structure nothing;
    return Judgement(data, model, held, nothing, judged).stays(0);
  };
  EXPECT_TRUE(stays(0.05));
  EXPECT_FALSE(stays(0.2));
}

/// Friction of 36 sessions that scatters by 4 %, 0.4 % more with each kelvin above 20 C.
struct WarmSessions {
  explicit WarmSessions(unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> scatter(0, 0.04);
    for (unsigned j = 0; j < 36; ++j) {
      temperature_C.push_back(20 + 20 * (j / 3 % 3));
      share.push_back(1 + 0.004 * (temperature_C.back() - 20) + scatter(engine));
      records.push_back(measured_at(temperature_C.back(),
                                    {.friction = 0.1 * share.back(),
                                     .load_N = 20,
                                     .still_N = 50,
                                     .noise_N = 0.2,
                                     .gain_scatter = 0.0},
                                    seed + j));
    }
  }

  /// What a line over the temperature leaves of the squares of the shares.
  [[nodiscard]] double left() const {
    double squares = 0;
    double product = 0;
    double all = 0;
    for (std::size_t j = 0; j < share.size(); ++j) {
      const double off_C = temperature_C[j] - effects::mean_of(temperature_C);
      const double off = share[j] - effects::mean_of(share);
      squares += off_C * off_C;
      product += off_C * off;
      all += off * off;
    }
    return 1 - product * product / squares / all;
  }

  std::vector<double> temperature_C;
  std::vector<double> share;
  std::vector<effects::ForceRecord> records;
};

/// Of normal scatter of unknown size beside a mean the logarithm of the likelihoods is (n - 1)/2 ln
/// of what is left of the squares. All of it is between the sessions.
TEST(ForceData, WhatMovesSessionsIsSeenByHowTheyScatter) {
  for (const unsigned seed : {11U, 12U, 13U}) {
    const WarmSessions warm(seed);
    ForceData data(warm.records);
    const ForceFit nominal = data.fit({}, {1, 0.03}, 15);
    data.learn_covariance(nominal, nominal, false);
    const ForceFit fit = data.with(nominal, effects::ForceTerm::temperature, 1);
    const PairedGain gain = paired_gain(data, data.held_out(nominal), data.held_out(fit), true);
    EXPECT_NEAR(gain.of_sessions, -17.5 * std::log(warm.left()), 0.15 * gain.of_sessions);
    EXPECT_LT(gain.within_N2, 0.02 * gain.moved_N2);
  }
}

/// Smoothing leaves 0.1 of the variance of white noise of 0.5 N, which makes the gain of a wave of
/// 2 N smaller by 0.1 * 0.25/2 = 1.2 %.
TEST(ForceData, NoiseOfTheOutputMakesTheGainNoSmaller) {
  constexpr unsigned kTimes = 20;
  double with_noise = 0;
  double beside_noise = 0;
  for (unsigned seed = 1; seed <= kTimes; ++seed) {
    ForceData data(measured({.friction = 0, .load_N = 2, .gain_scatter = 0}, seed));
    const ForceFit fit = data.fit({}, {1, 0.1}, 15);
    data.learn_covariance(fit, fit, false);
    const ForceFit finished = data.finished(fit);
    with_noise += finished.parameters[0] / kTimes;
    beside_noise += data.beside_output_noise(finished).parameters[0] / kTimes;
  }
  EXPECT_NEAR(with_noise, 0.988, 0.005);
  EXPECT_NEAR(beside_noise, 1, 0.005);
}

/// What is noise throughout has no gain that could be made larger.
TEST(ForceData, NoiseAloneMovesNothing) {
  const ForceData data(measured({.friction = 0, .load_N = 0, .viscous_N_s_m = 40}, 3));
  const ForceFit fit = data.with(data.fit({}, {1, 0.1}, 15), effects::ForceTerm::velocity, 1);
  EXPECT_EQ(data.beside_output_noise(fit).parameters, fit.parameters);
}

/// Friction of sessions is 5 % off, and one of eight is 20 K warmer: 0.05/20 of the coefficient
/// is not known, though no other session gainsays that one.
TEST(ForceData, WhatOneSessionShowsIsNotKnownBetterThanSessionsScatter) {
  constexpr unsigned kTimes = 20;
  int inside = 0;
  for (unsigned seed = 1; seed <= kTimes; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> scatter(1, 0.05);
    std::vector<effects::ForceRecord> records;
    for (unsigned j = 0; j < 8; ++j) {
      const double warm_K = j == 5 ? 20 : 0;
      records.push_back(measured_at(20 + warm_K,
                                    {.friction = 0.3 * scatter(engine) * (1 + 0.01 * warm_K),
                                     .noise_N = 0.1,
                                     .gain_scatter = 0},
                                    100 * seed + j));
    }
    ForceData data(std::move(records));
    const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
    data.learn_covariance(nominal, data.with(nominal, effects::ForceTerm::temperature, 1), false);
    const ForceFit fit = data.with(nominal, effects::ForceTerm::temperature, 1);
    inside += std::abs(fit.parameters[2] - 0.01) < data.half_widths(fit)[2] ? 1 : 0;
  }
  EXPECT_GE(inside, 18);
}

/// A load of 40 N that changes by 5 % hardly tells friction in proportion to it from another force:
/// by 1.4 N. Where none of the former is left, which cannot be less, 6,000 samples of a noise of
/// 0.7 N know the latter to 2.2 * 0.7 N/78.
TEST(ForceData, WhatLiesAtABoundLeavesOthersKnown) {
  int at_bound = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const ForceData data(measured(
        {.friction = 0, .load_N = 2, .still_N = 40, .preload_N = 3, .gain_scatter = 0}, seed));
    const ForceFit fit = data.with(data.fit({}, {1, 0.03}, 15), effects::ForceTerm::preload, 1);
    if (fit.parameters[1] == 0) {
      ++at_bound;
      EXPECT_NEAR(data.half_widths(fit)[2], 0.02, 0.015);
      EXPECT_GT(data.half_widths(fit)[1], 0.002);
    } else {
      EXPECT_GT(data.half_widths(fit)[2], 0.2);
    }
  }
  EXPECT_GE(at_bound, 2);
  EXPECT_LE(at_bound, 6);
}

/// A normal density of a usual size, here 5 % of the force, at the value that was found, times the
/// standard error over that size; of four times as many sessions that is half as large.
TEST(ForceData, WhatIsKnownBetterWasLessLikelyBefore) {
  const auto occam = [](int sessions) {
    const ForceData data(measured({.preload_N = 3, .gain_scatter = 0.0}, 21, sessions));
    const ForceFit fit = data.with(data.fit({}, {1, 0.006}, 15), effects::ForceTerm::preload, 1);
    const double usual_N = 0.05 * data.scales().larger_N();
    const double off = fit.parameters[2] / usual_N;
    const double known =
        data.half_widths(fit)[2] / statistics::student95(static_cast<double>(sessions) - 3);
    // By how noisy all directions are in the mean, of which this one is as much as chance has it.
    EXPECT_NEAR(data.log_occam(fit, 0), -off * off / 2 + std::log(known / usual_N), 0.3);
    return data.log_occam(fit, 0);
  };
  EXPECT_NEAR(occam(12) - occam(48), std::log(2), 0.6);
}

/// b, d and what friction there is of the rest.
TEST(ForceData, ATendonThatHoldsAllOfItsForceIsNotLoose) {
  const ForceData data(measured({}, 6));
  const auto is_loose = [&](double log_drop) {
    return data.is_physical({{effects::ForceTerm::loose_tendon}, {1, 0.1, 0.002, log_drop, 0.5}, 0},
                            0);
  };
  EXPECT_FALSE(is_loose(0));
  EXPECT_TRUE(is_loose(0.05));
}

/// Bounds go by force over stroke, 28 N / 0.1 m, from 0.01 to 10,000 of them: a tendon whose
/// friction of 2 % stretches it by its stroke is soft, not at a bound, as is one that hardly
/// stretches.
TEST(ForceData, ATendonIsSoftOrStiffWithinBounds) {
  const ForceData data(measured({}, 7));
  const double unit_N_m = data.scales().force_N / data.scales().stroke_m;
  const auto within = [&](double units) {
    return data.is_physical({{effects::ForceTerm::compliance}, {1, 0.1, units * unit_N_m}, 0}, 0);
  };
  EXPECT_FALSE(within(0.01));
  EXPECT_TRUE(within(0.02));
  EXPECT_TRUE(within(9900));
  EXPECT_FALSE(within(10000));
}

/// Lengths in m, ln of what the tendon lacks: below 0.04 that is none.
TEST(ForceData, AnEffectOfWhichEverySizeMayBeZeroMayBeNone) {
  using effects::ForceTerm;
  const ForceData data(measured({}, 6));
  const auto may_be_none = [&](ForceTerm term, std::vector<double> parameters,
                               std::vector<double> half) {
    parameters.insert(parameters.begin(), {1, 0.1});
    half.insert(half.begin(), {0.01, 0.01});
    return data.may_be_none({{term}, parameters, 0}, 0, half);
  };
  EXPECT_FALSE(may_be_none(ForceTerm::preload, {3}, {2.9}));
  EXPECT_TRUE(may_be_none(ForceTerm::preload, {3}, {3.1}));
  EXPECT_FALSE(may_be_none(ForceTerm::zero, {-3}, {2.9}));
  // One of several is enough: viscous friction, or the Stribeck peak, at any speed of that.
  EXPECT_FALSE(may_be_none(ForceTerm::stribeck, {0.2, 0.01, 0.02}, {0.3, 0.009, 0.001}));
  EXPECT_TRUE(may_be_none(ForceTerm::stribeck, {0.2, 0.01, 0.02}, {0.3, 0.011, 0.001}));
  // A tendon is loose over a length and by a drop, whatever rubs.
  EXPECT_FALSE(may_be_none(ForceTerm::loose_tendon, {2e-3, 0.1, 0}, {1e-3, 0.05, 1}));
  EXPECT_TRUE(may_be_none(ForceTerm::loose_tendon, {2e-3, 0.1, 1}, {3e-3, 0.05, 0.1}));
  EXPECT_TRUE(may_be_none(ForceTerm::loose_tendon, {2e-3, 0.1, 1}, {1e-3, 0.07, 0.1}));
  // What gives way by a stiffness that has no end is none.
  EXPECT_FALSE(may_be_none(ForceTerm::compliance, {5e4}, {4e4}));
  EXPECT_TRUE(may_be_none(ForceTerm::compliance, {5e4}, {6e4}));
}

/// One sample in fifty is 30 N off, of a joint with 12 N of friction and noise of 0.7 N.
TEST(WithoutOutliers, SamplesThatAreFarOffHaveNoPart) {
  std::vector<effects::ForceRecord> records = measured({.preload_N = 12}, 3);
  for (effects::ForceRecord& record : records) {
    for (std::size_t i = 20; i < record.samples(); i += 50) {
      record.input_N[i] += 30;
    }
  }
  const ForceData data(records);
  const ForceFit all = data.fit({effects::ForceTerm::preload}, {1, 0.1, 10}, 15);
  const ForceData inliers = data.without_outliers(all);
  std::ptrdiff_t left_out = 0;
  for (const effects::ForceRecord& record : inliers.records()) {
    for (std::size_t i = 20; i < record.samples(); i += 50) {
      EXPECT_FALSE(record.used[i]) << record.session << ' ' << i;
    }
    left_out += std::ranges::count(record.used, false);
  }
  EXPECT_LE(left_out, 240);  // of them 120, and others where friction turns over between samples
  EXPECT_NEAR(inliers.finished(all).parameters[2], 12, 0.1);
}

/// Gains of sessions are 2 % above 1 and 2 % below in turn; only the upper ones have outliers.
TEST(WithoutOutliers, SessionsThatHadSomeSayNoMoreOfTheGainThanOthers) {
  std::vector<effects::ForceRecord> records = measured({.noise_N = 0.1}, 4);
  for (std::size_t j = 0; j < records.size(); ++j) {
    const bool upper = j % 2 == 0;
    for (std::size_t i = 0; i < records[j].samples(); ++i) {
      records[j].input_N[i] *= upper ? 1.02 : 0.98;
      records[j].input_N[i] += upper && i % 20 == 7 ? 2 : 0;
    }
  }
  ForceData data(records);
  const ForceFit nominal = data.fit({}, {1, 0.1}, 15);
  data.learn_covariance(nominal, nominal, false);
  const ForceData inliers = data.without_outliers(data.finished(nominal));
  EXPECT_NEAR(inliers.finished(nominal).parameters[0], 1, 0.004);
}

}  // namespace
}  // namespace host_sim::diagnose
