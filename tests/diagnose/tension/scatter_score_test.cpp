#include "host_sim/diagnose/tension/scatter_score.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "host_sim/statistics/random.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(BlockInverse, GivesTheQuadraticFormOfABlock) {
  Eigen::Matrix3d left;
  left << 5, 9, 9, 9, 4, 2, 9, 2, 3;
  const BlockInverse inverse = inverse_of(left, Vector3d(5, 4, 3), 1, 2);
  EXPECT_EQ(inverse.freedom(), 2);
  // The inverse of 4 2; 2 3 is 3 -2; -2 4 over 8: (1, 2) makes (3 - 8 + 16)/8.
  EXPECT_NEAR(inverse.statistic(Vector3d(7, 1, 2)), 11.0 / 8, 1e-12);
}

TEST(BlockInverse, LeavesOutDirectionsThatAreNotThere) {
  Matrix2d left;
  left << 4, 4, 4, 4;
  const BlockInverse inverse = inverse_of(left, Vector2d(4, 4), 0, 2);
  EXPECT_EQ(inverse.freedom(), 1);
  // 8 along (1, 1)/sqrt 2, where (2, 2) has 2 sqrt 2.
  EXPECT_NEAR(inverse.statistic(Vector2d(2, 2)), 1, 1e-12);
  EXPECT_EQ(inverse_of(Matrix2d::Zero(), Vector2d(4, 4), 0, 2).freedom(), 0);
  EXPECT_EQ(inverse_of(Matrix2d::Zero(), Vector2d(4, 4), 0, 2).statistic(Vector2d(2, 2)), 0);
}

TEST(BlockInverse, DeterminantsDifferAsTheyShould) {
  Matrix2d one, other;
  one << 1, 3, 3, 100;
  other << 0.9, 8, 8, 80;
  const Vector2d before(1, 100);
  EXPECT_NEAR(log_pseudo_determinant(one, before) - log_pseudo_determinant(other, before),
              std::log(91.0 / 8), 1e-12);
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Columns: 1, -phi s, an effect, a probe of two columns, the response.
constexpr Index kRefitted = 3, kProbed = 5, kSize = 6;
constexpr NoiseModel kNoise{.sample_sd = 0.3, .session_gain_sd = 0.2, .session_friction_sd = 0.1};

struct Whole {
  std::vector<MatrixXd> sessions;
  Grams grams;
  Products products;
};

Whole three_sessions() {
  Whole whole;
  whole.grams.layout.columns.resize(kSize);
  whole.grams.layout.probes = {
      {.probe = {.of = Probe::Of::speed, .edges = {}}, .first = kRefitted}};
  whole.products.total = VectorXd::Zero(kSize - 1);
  statistics::Random random(12, 0, 0);
  for (const Index rows : {9, 6, 7}) {
    MatrixXd columns(rows, kSize);
    for (Index i = 0; i < rows; ++i) {
      columns(i, 0) = 1;
      columns(i, 1) = i % 2 == 0 ? -1.5 : 1.2;
      for (Index j = 2; j < kSize; ++j) {
        columns(i, j) = random.uniform() - 0.3;
      }
    }
    whole.grams.sessions.push_back({.session = {},
                                    .gram = columns.transpose() * columns,
                                    .samples = static_cast<std::size_t>(rows),
                                    .bend_angle_rad = 1.5});
    const VectorXd products = columns.leftCols(kSize - 1).transpose() * columns.col(kSize - 1);
    whole.products.common.push_back(products.head<2>());
    whole.products.total += products;
    whole.sessions.push_back(columns);
  }
  return whole;
}

/// From the covariance of all samples as one matrix.
struct Dense {
  double log_determinants = 0;
  double left = 0;  ///< y'V^-1 y once `columns` are fitted
};

Dense by_one_matrix(const Whole& whole, const NoiseModel& noise, Index columns) {
  MatrixXd covariance = MatrixXd::Identity(22, 22) * noise.sample_sd * noise.sample_sd;
  MatrixXd all(22, kSize);
  Index at = 0;
  for (const MatrixXd& session : whole.sessions) {
    const MatrixXd scatter =
        session.leftCols(2) *
        Eigen::Vector2d(noise.session_gain_sd, noise.session_friction_sd).asDiagonal();
    covariance.block(at, at, session.rows(), session.rows()) += scatter * scatter.transpose();
    all.middleRows(at, session.rows()) = session;
    at += session.rows();
  }
  const MatrixXd inverse = algebra::inverse(covariance);
  const MatrixXd fitted = all.leftCols(columns);
  const MatrixXd weighted = inverse * fitted;
  const MatrixXd information = fitted.transpose() * weighted;
  const VectorXd response = all.col(kSize - 1);
  const VectorXd score = weighted.transpose() * response;
  const VectorXd weighted_response = inverse * response;
  return {std::log(algebra::determinant(covariance)) + std::log(algebra::determinant(information)),
          response.dot(weighted_response) - score.dot(algebra::solved(information, score).col(0))};
}

TEST(ScatterScore, DevianceIsThatOfTheRestrictedLikelihood) {
  const Whole whole = three_sessions();
  const auto deviance = [&](const NoiseModel& noise) {
    return ScatterScore(whole.grams, noise, kRefitted).deviance(whole.grams, whole.products);
  };
  const auto dense = [&](const NoiseModel& noise) {
    const Dense found = by_one_matrix(whole, noise, kRefitted);
    return found.log_determinants + found.left;
  };
  for (const auto& [gain_sd, friction_sd] : {std::pair{0.9, 0.1}, {0.01, 0.1}, {0.2, 1.3}}) {
    NoiseModel other = kNoise;
    other.session_gain_sd = gain_sd;
    other.session_friction_sd = friction_sd;
    EXPECT_NEAR(deviance(other) - deviance(kNoise), dense(other) - dense(kNoise), 1e-9);
  }
}

TEST(ScatterScore, StatisticIsWhatTheProbeExplainsBesideTheModel) {
  const Whole whole = three_sessions();
  ScatterScore score(whole.grams, kNoise, kRefitted);
  score.prepare_probes(whole.grams);
  const auto statistics = score.statistics(whole.grams, whole.products);
  ASSERT_EQ(statistics.size(), 1U);
  EXPECT_EQ(score.freedom(0), 2);
  EXPECT_NEAR(
      statistics[0],
      by_one_matrix(whole, kNoise, kRefitted).left - by_one_matrix(whole, kNoise, kProbed).left,
      1e-9);
}

TEST(ScatterScore, ExplainedIsWhatTheEffectsTakeOff) {
  const Whole whole = three_sessions();
  EXPECT_NEAR(ScatterScore(whole.grams, kNoise, kRefitted).explained(whole.grams, whole.products),
              by_one_matrix(whole, kNoise, 2).left - by_one_matrix(whole, kNoise, kRefitted).left,
              1e-9);
}

}  // namespace
}  // namespace host_sim::diagnose
