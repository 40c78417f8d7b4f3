#include "host_sim/diagnose/force/force_covariance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/diagnose/force/paired_gain.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

/// Of what the joint itself leaves.
ForceData learned(const Joint& joint, unsigned seed, int sessions = 40) {
  ForceData data(measured(joint, seed, sessions));
  const ForceFit fit = data.fit({}, {1, 0.01}, 15);
  data.learn_covariance(fit, fit, true);
  return data;
}

Eigen::VectorXd drawn(const effects::ForceRecord& record, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd values(static_cast<Eigen::Index>(record.samples()));
  for (double& value : values) {
    value = normal(engine);
  }
  return values;
}

TEST(ForceCovariance, WithoutItSumsArePlain) {
  const ForceData data(measured({}, 1));
  const Eigen::VectorXd a = drawn(data.records()[0], 1);
  const Eigen::VectorXd b = drawn(data.records()[0], 2);
  EXPECT_DOUBLE_EQ(data.covariance().product(0, a, b)(0, 0), a.dot(b));
}

/// The scatter of 40 draws is known to a ninth; half of that of the joint is far off.
TEST(ForceCovariance, LearnsHowGainsScatter) {
  EXPECT_NEAR(learned({.gain_scatter = 0.02}, 2).covariance().log_gain_sd(), 0.02, 0.008);
  EXPECT_NEAR(learned({.gain_scatter = 0.005}, 2).covariance().log_gain_sd(), 0.005, 0.002);
  EXPECT_LT(learned({.gain_scatter = 0}, 2).covariance().log_gain_sd(), 0.001);
  EXPECT_LT(learned({.gain_scatter = 0.02}, 2).covariance().friction_sd(), 0.002);
}

/// Of 40 N that turn over the mean square is 800 N2.
TEST(ForceCovariance, TheMeanOfSessionsScattersByAsMuchLessAsTheyAre) {
  const ForceData data = learned({.gain_scatter = 0.02}, 2);
  const double expected_N2 = std::pow(data.covariance().log_gain_sd(), 2) * 800 /
                             static_cast<double>(data.records().size());
  EXPECT_NEAR(data.scatter_of_mean_N2(), expected_N2, 0.1 * expected_N2);
}

TEST(ForceCovariance, WhatScattersMoreThanAnyGainIsNotAllScatter) {
  EXPECT_DOUBLE_EQ(learned({.gain_scatter = 0.3}, 3).covariance().log_gain_sd(), 0.03);
}

TEST(ForceCovariance, AGainOfTheSessionCostsLittleAndAllElseAsMuchAsBefore) {
  const ForceData data = learned({.gain_scatter = 0.02}, 4);
  const effects::ForceRecord& record = data.records()[3];
  const Eigen::Map<const Eigen::VectorXd> force_N(record.output_N.data(),
                                                  static_cast<Eigen::Index>(record.samples()));
  const Eigen::VectorXd gain = force_N / force_N.norm();
  Eigen::VectorXd other = drawn(record, 5);
  other -= gain * gain.dot(other);
  other /= other.norm();
  EXPECT_LT(data.covariance().product(3, gain, gain)(0, 0), 0.05);
  EXPECT_NEAR(data.covariance().product(3, other, other)(0, 0), 1, 0.25);
  EXPECT_NEAR(data.covariance().product(3, gain, other)(0, 0),
              data.covariance().product(3, other, gain)(0, 0), 1e-12);
}

/// Refits that are known exactly, of 20 sessions: one half above and the other below zero.
std::vector<ForceCovariance::Refit> refits(double log_gain, double friction) {
  std::vector<ForceCovariance::Refit> all;
  for (int j = 0; j < 20; ++j) {
    const double sign = j % 2 == 0 ? 1 : -1;
    all.push_back(
        {Eigen::Vector2d(sign * log_gain, sign * friction), 1e-16 * Eigen::Matrix2d::Identity()});
  }
  return all;
}

/// Whatever they scatter by: a tenth of it is ten times as likely for each session but one, which
/// the mean is of: 19 ln 10. A gain or friction that all of them have is the model's.
TEST(ForceCovariance, SessionsThatScatterLessAreMoreLikely) {
  const ForceCovariance covariance = learned({.gain_scatter = 0.01}, 7).covariance();
  const Eigen::Array2d most = covariance.most_scatter();
  const auto log_likelihood = [&](double of_gain, double of_friction) {
    return covariance.log_likelihood_of(refits(of_gain * most[0], of_friction * most[1]));
  };
  EXPECT_NEAR(log_likelihood(0.3, 0.05) - log_likelihood(0.3, 0.5), 19 * std::log(10), 0.01);
  EXPECT_NEAR(log_likelihood(0.05, 0.3) - log_likelihood(0.5, 0.3), 19 * std::log(10), 0.01);
  std::vector<ForceCovariance::Refit> all = refits(0.3 * most[0], 0.2 * most[1]);
  const double before = covariance.log_likelihood_of(all);
  std::ranges::reverse(all);
  EXPECT_NEAR(covariance.log_likelihood_of(all), before, 1e-9);
  for (ForceCovariance::Refit& refit : all) {
    refit.value += Eigen::Vector2d(0.1, 0.02);
  }
  EXPECT_NEAR(covariance.log_likelihood_of(all), before, 1e-6);
}

/// Known ten times worse than anything scatters, it is the normal density of each beside their
/// mean: one of five that is 2 sigma off takes exp(-2 * 4/5).
TEST(ForceCovariance, SessionsOfWhichLittleIsKnownAreAsLikelyAsThatSays) {
  const ForceCovariance covariance = learned({.gain_scatter = 0.01}, 7).covariance();
  const Eigen::Array2d sd = 10 * covariance.most_scatter();
  std::vector<ForceCovariance::Refit> all(
      5, {Eigen::Vector2d::Zero(), sd.square().matrix().asDiagonal()});
  const double before = covariance.log_likelihood_of(all);
  all[3].value(1) = 2 * sd[1];
  EXPECT_NEAR(covariance.log_likelihood_of(all) - before, -1.6, 0.02);
}

/// What gain and friction do of a session is none of what they leave.
TEST(ForceCovariance, ARefitLeavesNothingOfItself) {
  const ForceData data = learned({.gain_scatter = 0.01}, 8);
  const Eigen::Map<const Eigen::VectorXd> force_N = vector_of(data.records()[2].output_N);
  const Eigen::VectorXd other = drawn(data.records()[2], 9);
  const ForceCovariance& covariance = data.covariance();
  EXPECT_LT(covariance.beside_refit(2, 0.03 * force_N).norm(), 0.05 * 0.03 * force_N.norm());
  EXPECT_LT((covariance.beside_refit(2, other + 0.03 * force_N) - covariance.beside_refit(2, other))
                .norm(),
            0.05 * 0.03 * force_N.norm());
  EXPECT_GT(covariance.beside_refit(2, other).norm(), 0.9 * other.norm());
}

/// Noise of 5 % beside 0.1 N: at 40 N a sample says (2 N / 0.1 N)^2 less than near zero.
TEST(ForceCovariance, ASampleCountsByItsNoise) {
  const ForceData data = learned({.noise_N = 0.1, .relative_noise = 0.05, .gain_scatter = 0.01}, 6);
  const effects::ForceRecord& record = data.records()[0];
  const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto of = [&](auto found) {
    Eigen::VectorXd one = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(record.samples()));
    one(found - record.output_N.begin()) = 1;
    return data.covariance().product(0, one, one)(0, 0);
  };
  const double near_zero = of(std::ranges::min_element(record.output_N, size));
  const double far = of(std::ranges::max_element(record.output_N, size));
  EXPECT_GT(near_zero / far, 50);
  EXPECT_GT(far, 0);
}

/// How many times as much a sample in the middle of the first stroke says as the one after it.
double middle_over_turn(const Joint& joint, bool with_timing) {
  ForceData data(measured(joint, 8));
  const ForceFit fit = data.finished(
      data.started(data.fit({}, {1, 0.01}, 15), std::array{effects::ForceTerm::preload}, 1)
          .front());
  data.learn_covariance(fit, fit, with_timing);
  const std::vector<double>& velocity_m_s = data.records()[0].velocity_m_s;
  const auto of = [&](std::size_t sample) {
    Eigen::VectorXd one = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(velocity_m_s.size()));
    one(static_cast<Eigen::Index>(sample)) = 1;
    return data.covariance().product(0, one, one)(0, 0);
  };
  std::size_t turn = 1;
  while (velocity_m_s[turn] * velocity_m_s[turn - 1] > 0) {
    ++turn;
  }
  return of(turn / 2) / of(turn);
}

/// 24 N of friction that turn within a millisecond and are read 3 ms sooner or later, beside 0.1 N
/// of noise: a sample at the turn says far less than one in the middle of the stroke, whether or
/// not samples are taken to be read at another time than their own elsewhere.
TEST(ForceCovariance, ASampleCountsByHowFastTheForceChanges) {
  const Joint late{.preload_N = 12, .noise_N = 0.1, .jitter_s = 0.003};
  EXPECT_GT(middle_over_turn(late, true), 10);
  EXPECT_GT(middle_over_turn(late, false), 10);
}

/// Without friction nothing turns over there.
TEST(ForceCovariance, ASampleAtATurnOfWhatDoesNotRubCountsAsOthersDo) {
  EXPECT_LT(middle_over_turn({.noise_N = 0.1}, false), 2);
}

class GainOf : public testing::Test {
 protected:
  static constexpr int kSessions = 12;
  const ForceData data{measured({}, 7, kSessions)};

  /// Noise of 0.1 N and a signal of 1 N in as many sessions, times what is left of it.
  [[nodiscard]] HeldOut left(int sessions, double share) const {
    HeldOut held;
    for (int j = 0; j < kSessions; ++j) {
      const Eigen::VectorXd noise =
          0.1 * drawn(data.records()[static_cast<std::size_t>(j)], static_cast<unsigned>(100 + j));
      std::vector<double>& left_N = held.residuals_N.emplace_back();
      for (Eigen::Index i = 0; i < noise.size(); ++i) {
        const double signal_N = j < sessions ? std::sin(0.1 * static_cast<double>(i) + j) : 0;
        left_N.push_back(noise(i) + share * signal_N);
      }
      const Eigen::Map<const Eigen::VectorXd> values(left_N.data(), noise.size());
      held.plain_N2.push_back(values.squaredNorm() / static_cast<double>(noise.size()));
      held.weighted_N2.push_back(held.plain_N2.back());
      held.beside_scatter_N2.push_back(held.plain_N2.back());
    }
    return held;
  }
};

TEST_F(GainOf, IsAsSureWhereFewSessionsShowAnEffect) {
  // As sure as twelve sessions and three can be, in standard errors of a normal distribution: t is
  // beyond 50, and sqrt(12 ln(1 + 50^2/11)) is 8.1.
  EXPECT_GT(paired_gain(data, left(kSessions, 1), left(kSessions, 0), true).z, 8);
  EXPECT_GT(paired_gain(data, left(3, 1), left(3, 0), true).z, 5);
}

/// What a delay takes off next to turns alone may be of filters, and what friction does there not.
TEST_F(GainOf, AnEffectOfTimeGainsAwayFromTurnsAsWell) {
  const auto at_turns = [&](HeldOut held, bool wanted) {
    for (std::size_t j = 0; j < held.residuals_N.size(); ++j) {
      const std::vector<bool> next = effects::next_to_turns(data.records()[j]);
      for (std::size_t i = 0; i < next.size(); ++i) {
        held.residuals_N[j][i] += next[i] == wanted ? (i % 2 == 0 ? 2 : -2) : 0;
      }
    }
    return held;
  };
  const HeldOut without = left(0, 0);
  using enum effects::ForceTerm;
  EXPECT_GT(gain_of(preload, data, at_turns(without, true), without).z, 8);
  EXPECT_LT(gain_of(delay, data, at_turns(without, true), without).z, 1);
  EXPECT_GT(gain_of(delay, data, at_turns(without, false), without).z, 8);
}

/// What one session alone shows is as uncertain as that session.
TEST_F(GainOf, IsNotSureWhereOneSessionAloneShowsIt) {
  EXPECT_LT(paired_gain(data, left(1, 1), left(1, 0), true).z, 2);
}

TEST_F(GainOf, TurnsRoundWithTheModels) {
  const PairedGain gain = paired_gain(data, left(kSessions, 1), left(kSessions, 0), false);
  const PairedGain loss = paired_gain(data, left(kSessions, 0), left(kSessions, 1), false);
  EXPECT_GT(gain.mean, 1.5);
  EXPECT_LT(loss.mean, -1.5);
  EXPECT_LT(loss.z, -7);
  EXPECT_GT(gain.log_odds, 100);
  EXPECT_LT(loss.log_odds, -100);
  // The signal has a mean square of 1/2 beside the noise.
  EXPECT_NEAR(gain.taken_N2, 0.5, 0.02);
  EXPECT_NEAR(loss.beside_scatter_N2, -0.5, 0.02);
  EXPECT_NEAR(loss.plain_N2, -0.5, 0.02);
}

/// A model that has the half of what is there takes three quarters of its square off. As a nested
/// one it is surely there, and not surely better than one that has the other half.
TEST_F(GainOf, ANestedModelIsTestedAgainstNothingAndAnotherAgainstEvenOdds) {
  const HeldOut half = left(kSessions, 0.5);
  EXPECT_GT(paired_gain(data, left(kSessions, 1), half, true).z, 8);
  EXPECT_NEAR(paired_gain(data, left(kSessions, 1), half, false).taken_N2, 0.375, 0.02);
  EXPECT_NEAR(paired_gain(data, half, left(kSessions, -0.5), false).z, 0, 4);
  EXPECT_GT(paired_gain(data, half, left(kSessions, -0.5), true).z, 4);
}

TEST_F(GainOf, IsNoneWhereBothLeaveAsMuch) {
  EXPECT_EQ(paired_gain(data, left(5, 1), left(5, 1), false).z, 0);
  EXPECT_LT(std::abs(paired_gain(data, left(kSessions, 1), left(kSessions, -1), false).z), 4);
}

TEST(ForceCovariance, WhatAGainDoesIsTakenOutOfResidualsAndAllElseStays) {
  const ForceData data = learned({.gain_scatter = 0.02}, 4);
  const effects::ForceRecord& record = data.records()[3];
  const Eigen::Map<const Eigen::VectorXd> force_N(record.output_N.data(),
                                                  static_cast<Eigen::Index>(record.samples()));
  const Eigen::VectorXd gain_N = 0.02 * force_N;
  EXPECT_LT(data.covariance().beside_scatter(3, gain_N).norm(), 0.05 * gain_N.norm());
  Eigen::VectorXd other_N = drawn(record, 5);
  EXPECT_NEAR(data.covariance().beside_scatter(3, other_N).norm(), other_N.norm(),
              0.01 * other_N.norm());
}

/// Noise of 0.5 N and as much again in proportion to the load: a sample near zero counts more.
TEST(ForceCovariance, WeightsAreOneInTheMean) {
  const ForceData data = learned({.relative_noise = 0.05}, 4);
  double sum = 0;
  double samples = 0;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    const effects::ForceRecord& record = data.records()[j];
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(record.samples()));
    sum += data.covariance().weighted_square(j, ones);
    samples += static_cast<double>(record.samples());
  }
  EXPECT_NEAR(sum / samples, 1, 1e-9);
  EXPECT_EQ(ForceCovariance().weight(0, 7), 1);
}

TEST(ForceCovariance, WithoutItResidualsAreAllThatIsLeft) {
  const ForceData data(measured({}, 1));
  const Eigen::VectorXd residuals_N = drawn(data.records()[0], 1);
  EXPECT_EQ(data.covariance().beside_scatter(0, residuals_N), residuals_N);
}

}  // namespace
}  // namespace host_sim::diagnose
