#include "host_sim/diagnose/force/session_drift.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <vector>

namespace host_sim::diagnose {
namespace {

using Refits = std::vector<ForceCovariance::Refit>;

const Eigen::Array2d kNoScatter = Eigen::Array2d::Zero();

Refits of_friction(const Eigen::VectorXd& friction) {
  Refits refits(static_cast<std::size_t>(friction.size()));
  for (std::size_t j = 0; j < refits.size(); ++j) {
    refits[j].value(1) = friction(static_cast<Eigen::Index>(j));
  }
  return refits;
}

TEST(SessionDrift, IsTheRatioOfVonNeumann) {
  // 1 .. 8: 7 differences of 1, and squares of 3.5, 2.5, 1.5, 0.5 twice
  EXPECT_DOUBLE_EQ(drift_of(Eigen::VectorXd::LinSpaced(8, 1, 8)).ratio, 7.0 / 42);
  Eigen::VectorXd to_and_fro(8);
  to_and_fro << 1, -1, 1, -1, 1, -1, 1, -1;
  EXPECT_DOUBLE_EQ(drift_of(to_and_fro).ratio, 28.0 / 8);
  EXPECT_GT(drift_of(to_and_fro).p, 0.99);
  EXPECT_EQ(drift_of(Eigen::VectorXd::LinSpaced(7, 1, 7)).p, 1);
  EXPECT_EQ(drift_of(Eigen::VectorXd::Constant(12, 3)).p, 1);
}

/// By as many normal values as say it to a tenth: 5 % and 1 % of them are below.
TEST(SessionDrift, ChanceShowsItAsOftenAsItSays) {
  constexpr int kDraws = 20'000;
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (const Eigen::Index sessions : {8, 12, 30}) {
    int twentieth = 0;
    int hundredth = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
      const double p =
          drift_of(Eigen::VectorXd::NullaryExpr(sessions, [&] { return normal(engine); })).p;
      twentieth += p < 0.05 ? 1 : 0;
      hundredth += p < 0.01 ? 1 : 0;
    }
    EXPECT_NEAR(twentieth, 0.05 * kDraws, 0.005 * kDraws) << sessions;
    EXPECT_NEAR(hundredth, 0.01 * kDraws, 0.002 * kDraws) << sessions;
  }
}

/// Sessions at angles that fall know their friction by a sixth as well in the end as at first, or
/// as at the other angles of the one before.
TEST(SessionDrift, NoiseThatNeighboursShareIsNone) {
  constexpr int kDraws = 20'000;
  constexpr std::size_t kSessions = 24;
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  int rare = 0;
  int rare_as_they_are = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    Refits refits(kSessions);
    Eigen::VectorXd friction(kSessions);
    for (std::size_t j = 0; j < kSessions; ++j) {
      const double sd = 6.0 / static_cast<double>(1 + j / 4);
      friction(static_cast<Eigen::Index>(j)) = sd * normal(engine);
      refits[j].value(1) = friction(static_cast<Eigen::Index>(j));
      refits[j].covariance(1, 1) = sd * sd;
    }
    rare += drift_of_either(standardized(refits, kNoScatter)).p < 0.01 ? 1 : 0;
    rare_as_they_are += drift_of(friction).p < 0.01 ? 1 : 0;
  }
  // One of both is asked, at twice its chance.
  EXPECT_NEAR(rare, 0.005 * kDraws, 0.002 * kDraws);
  EXPECT_GT(rare_as_they_are, 0.03 * kDraws);
}

/// Friction of a room whose air turns once: half of it is what a line takes off.
TEST(SessionDrift, WhatRisesWithTheSessionsMayBeAPartOfIt) {
  constexpr Eigen::Index kSessions = 16;
  const Eigen::ArrayXd place = Eigen::ArrayXd::LinSpaced(kSessions, -1, 1);
  const Eigen::ArrayXd air = (2.5 * place).sin() + 0.6 * (5 * place).cos();
  const double slope = (place * air).sum() / place.square().sum();
  const Refits without = of_friction(air);
  const Refits with = of_friction(air - slope * place);
  EXPECT_LT(drift_of_either(standardized(with, kNoScatter)).p, 1e-3);
  EXPECT_TRUE(may_be_drift(with, without, kNoScatter));

  // A line that is all but a little of it, and one beside chance alone, are none.
  const Refits large = of_friction(air + 8 * place);
  EXPECT_FALSE(may_be_drift(with, large, kNoScatter));
  Eigen::ArrayXd chance(kSessions);
  chance << 1, -1, 0.5, -0.8, -0.2, 1, -0.7, 0.1, 0.9, -1, 0.3, -0.6, 0.8, -0.1, -0.9, 0.7;
  EXPECT_FALSE(may_be_drift(of_friction(chance), of_friction(chance + 2 * place), kNoScatter));

  // What changes places does not drift, whatever is left.
  Eigen::ArrayXd heated(kSessions);
  heated << 1, -1, -1, 1, -1, 1, 1, -1, 1, -1, 1, -1, -1, 1, -1, 1;
  EXPECT_FALSE(may_be_drift(with, of_friction(air - slope * place + heated), kNoScatter));
}

}  // namespace
}  // namespace host_sim::diagnose
