#include "host_sim/diagnose/evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "host_sim/statistics/random.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kFirst = 2, kSecond = 3, kResponse = 4, kSize = 5;

/// Columns of sessions as a whole, and their Gram matrices: 1, -phi s, two signatures, responses.
struct Whole {
  std::vector<MatrixXd> sessions;
  Grams grams;
};

Whole three_sessions() {
  Whole whole;
  whole.grams.layout.columns.resize(kSize);
  statistics::Random random(11, 0, 0);
  for (const Index rows : {9, 6, 7}) {
    MatrixXd columns(rows, kSize);
    for (Index i = 0; i < rows; ++i) {
      columns(i, 0) = 1;
      columns(i, 1) = i % 2 == 0 ? -1.5 : 1.5;
      for (Index j = 2; j < kSize; ++j) {
        columns(i, j) = random.uniform() - 0.5;
      }
    }
    whole.grams.sessions.push_back({.session = {},
                                    .gram = columns.transpose() * columns,
                                    .samples = static_cast<std::size_t>(rows),
                                    .bend_angle_rad = 1.5});
    whole.sessions.push_back(columns);
  }
  return whole;
}

/// The same from the covariance of all samples as one matrix: every random term written into it,
/// gain and friction of all sessions by generalised least squares.
double by_one_matrix(const Whole& whole, const NoiseModel& noise, const Terms& terms) {
  Index rows = 0;
  for (const MatrixXd& columns : whole.sessions) {
    rows += columns.rows();
  }
  MatrixXd covariance = MatrixXd::Identity(rows, rows) * noise.sample_sd * noise.sample_sd;
  MatrixXd common(rows, 2);
  VectorXd responses(rows);
  MatrixXd with_prior = MatrixXd::Zero(rows, static_cast<Index>(terms.columns.size()));
  Index at = 0;
  for (const MatrixXd& columns : whole.sessions) {
    const Index count = columns.rows();
    const MatrixXd random =
        columns.leftCols(2) *
        Eigen::Vector2d(noise.session_gain_sd, noise.session_friction_sd).asDiagonal();
    covariance.block(at, at, count, count) += random * random.transpose();
    common.middleRows(at, count) = columns.leftCols(2);
    responses.segment(at, count) = columns.col(kResponse);
    for (Index i = 0; i < with_prior.cols(); ++i) {
      const auto term = static_cast<std::size_t>(i);
      with_prior.col(i).segment(at, count) =
          columns.col(terms.columns[term]) * terms.prior_sd[term];
      responses.segment(at, count) -= columns.col(terms.columns[term]) * terms.prior_mean[term];
    }
    at += count;
  }
  const auto quadratic = [&](const MatrixXd& inverse) {
    const MatrixXd weighted = inverse * common;
    const MatrixXd information = common.transpose() * weighted;
    const VectorXd score = weighted.transpose() * responses;
    const VectorXd response = inverse * responses;
    return responses.dot(response) - score.dot(algebra::solved(information, score).col(0));
  };
  const MatrixXd all = covariance + with_prior * with_prior.transpose();
  const MatrixXd inverse = algebra::inverse(all);
  const MatrixXd weighted = inverse * common;
  const MatrixXd information = common.transpose() * weighted;
  const double samples = static_cast<double>(rows);
  return -(std::log(algebra::determinant(all)) + std::log(algebra::determinant(information)) +
           samples * std::log(quadratic(inverse) / samples)) /
         2;
}

constexpr NoiseModel kNoise{.sample_sd = 0.3, .session_gain_sd = 0.2, .session_friction_sd = 0.1};

double samples_of(const Whole& whole) {
  double samples = 0;
  for (const SessionGram& session : whole.grams.sessions) {
    samples += static_cast<double>(session.samples);
  }
  return samples;
}

TEST(Evidence, DifferencesAreThoseOfTheWholeCovariance) {
  const Whole whole = three_sessions();
  const std::vector<ScatterPoint> one{scatter_point(whole.grams, kNoise)};
  const double none = log_evidence(one, {}, kResponse, samples_of(whole));
  const double none_whole = by_one_matrix(whole, kNoise, {});
  for (const Terms& terms :
       {Terms{{kFirst}, {0}, {0.7}}, Terms{{kSecond}, {0}, {0.01}}, Terms{{kFirst}, {1.0}, {0.25}},
        Terms{{kFirst, kSecond}, {0, -0.8}, {2.0, 0.5}}}) {
    EXPECT_NEAR(log_evidence(one, terms, kResponse, samples_of(whole)) - none,
                by_one_matrix(whole, kNoise, terms) - none_whole, 1e-9);
  }
}

TEST(Evidence, DifferencesOfScatterAreThoseOfTheWholeCovariance) {
  const Whole whole = three_sessions();
  NoiseModel wide = kNoise;
  wide.session_gain_sd = 0.9;
  const auto at = [&](const NoiseModel& noise) {
    return log_evidence({scatter_point(whole.grams, noise)}, {}, kResponse, samples_of(whole));
  };
  EXPECT_NEAR(at(wide) - at(kNoise),
              by_one_matrix(whole, wide, {}) - by_one_matrix(whole, kNoise, {}), 1e-9);
}

TEST(Evidence, OfAGridIsTheMeanOfItsPoints) {
  const Whole whole = three_sessions();
  NoiseModel wide = kNoise;
  wide.session_friction_sd = 0.8;
  const Terms terms{{kFirst}, {0.4}, {0.7}};
  const ScatterPoint one = scatter_point(whole.grams, kNoise);
  const ScatterPoint other = scatter_point(whole.grams, wide);
  const double samples = samples_of(whole);
  EXPECT_NEAR(std::exp(log_evidence({one, other}, terms, kResponse, samples)),
              (std::exp(log_evidence({one}, terms, kResponse, samples)) +
               std::exp(log_evidence({other}, terms, kResponse, samples))) /
                  2,
              1e-9);
}

TEST(Evidence, ATermThatExplainsNothingCostsItsPrior) {
  Whole whole = three_sessions();
  for (SessionGram& session : whole.grams.sessions) {
    session.gram.row(kFirst).setZero();
    session.gram.col(kFirst).setZero();
    session.gram(kFirst, kFirst) = 1;
  }
  const std::vector<ScatterPoint> one{scatter_point(whole.grams, kNoise)};
  // 3 sessions give the column 3 / sample_sd^2, times the prior's variance: 1 + 3 (0.6 / 0.3)^2.
  EXPECT_NEAR(log_evidence(one, {{kFirst}, {0}, {0.6}}, kResponse, samples_of(whole)) -
                  log_evidence(one, {}, kResponse, samples_of(whole)),
              -std::log(13.0) / 2, 1e-12);
}

TEST(Evidence, TheGridHoldsTheScatterOfUsualCampaigns) {
  const Whole whole = three_sessions();
  bool below = false;
  bool above = false;
  for (const ScatterPoint& point : scatter_grid(whole.grams, 0.3)) {
    EXPECT_EQ(point.noise.sample_sd, 0.3);
    below |= point.noise.session_gain_sd < 0.001 && point.noise.session_friction_sd < 0.001;
    above |= point.noise.session_gain_sd > 0.03 && point.noise.session_friction_sd > 0.015;
  }
  EXPECT_TRUE(below);
  EXPECT_TRUE(above);
}

/// Of an input that is the output times a number, gain takes all: what is left is a difference of
/// sums, and as soon below zero as above it.
TEST(Evidence, IsFiniteWhereNothingIsLeft) {
  ScatterPoint exact{.noise = {}, .left = MatrixXd::Identity(kSize, kSize)};
  exact.left(kResponse, kResponse) = -1e-14;
  EXPECT_TRUE(std::isfinite(log_evidence({exact}, {}, kResponse, 100)));
}

}  // namespace
}  // namespace host_sim::diagnose
