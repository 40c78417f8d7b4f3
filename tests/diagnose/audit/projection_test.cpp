#include "host_sim/diagnose/audit/projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/diagnose/audit/records.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose {
namespace {

std::vector<effects::ForceRecord> three_poses() {
  return testing::records_of({{.bend_angle_rad = 1.5, .start_cycle = 10, .duration_s = 0.8},
                              {.bend_angle_rad = 3, .sheath_C = 40, .duration_s = 1},
                              {.bend_angle_rad = 4, .start_cycle = 900, .duration_s = 1.2}});
}

/// The columns of all sessions over their noise, below one another: fine for a few samples.
std::vector<Eigen::MatrixXd> columns_over_noise(const std::vector<effects::ForceRecord>& records,
                                                const Grams& grams, const NoiseModel& noise) {
  std::vector<Eigen::MatrixXd> all;
  for (std::size_t j = 0; j < records.size(); ++j) {
    Eigen::MatrixXd& columns = all.emplace_back(
        columns_of(records[j], grams.layout, sharp_scales_of(records), testing::kMu));
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
      columns.row(i) /= noise.sample_sd_N[j][static_cast<std::size_t>(i)];
    }
  }
  return all;
}

Eigen::MatrixXd stacked(const std::vector<Eigen::MatrixXd>& sessions) {
  Eigen::MatrixXd all(0, sessions.front().cols());
  for (const Eigen::MatrixXd& session : sessions) {
    all.conservativeResize(all.rows() + session.rows(), Eigen::NoChange);
    all.bottomRows(session.rows()) = session;
  }
  return all;
}

/// V of the header over the noise of samples, whole.
Eigen::MatrixXd covariance(const std::vector<Eigen::MatrixXd>& sessions, const NoiseModel& noise) {
  const Eigen::Index size = stacked(sessions).rows();
  Eigen::MatrixXd v = Eigen::MatrixXd::Identity(size, size);
  Eigen::Index first = 0;
  for (const Eigen::MatrixXd& session : sessions) {
    const Eigen::Index count = session.rows();
    v.block(first, first, count, count) += noise.session_gain_sd * noise.session_gain_sd *
                                               session.col(0) * session.col(0).transpose() +
                                           noise.session_friction_sd * noise.session_friction_sd *
                                               session.col(1) * session.col(1).transpose();
    first += count;
  }
  return v;
}

void expect_near(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected,
                 const Eigen::MatrixXd& scale, double tolerance) {
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.cols(); ++j) {
      ASSERT_NEAR(found(i, j), expected(i, j), tolerance * std::sqrt(scale(i, i) * scale(j, j)))
          << i << ' ' << j;
    }
  }
}

TEST(Projection, IsGeneralisedLeastSquaresWithTheWholeCovariance) {
  const auto records = three_poses();
  const NoiseModel noise = testing::usual_noise(records);
  const Grams grams = gram_of(records, testing::kMu, noise, 0);
  const Projection projection = project(grams, noise);

  const auto sessions = columns_over_noise(records, grams, noise);
  const Eigen::MatrixXd columns = stacked(sessions);
  const Eigen::MatrixXd weighed = algebra::solved(covariance(sessions, noise), columns);
  const Eigen::MatrixXd before = columns.transpose() * weighed;
  const Eigen::MatrixXd plain = columns.transpose() * columns;
  expect_near(projection.before, before, plain, 1e-9);

  const Eigen::Matrix2d common = before.topLeftCorner<2, 2>();
  const Eigen::MatrixXd left =
      before - before.leftCols<2>() * common.inverse() * before.topRows<2>();
  expect_near(projection.left, left, plain, 1e-9);
}

TEST(Projection, WithoutScatterSessionsAreOne) {
  const auto records = three_poses();
  NoiseModel noise = testing::usual_noise(records);
  noise.session_gain_sd = 0;
  noise.session_friction_sd = 0;
  const Grams grams = gram_of(records, testing::kMu, noise, 0);
  const Eigen::MatrixXd columns = stacked(columns_over_noise(records, grams, noise));
  const Eigen::MatrixXd common = columns.leftCols<2>();
  const Eigen::MatrixXd rest = algebra::left_by(common, columns);
  const Projection projection = project(grams, noise);
  expect_near(projection.left, rest.transpose() * rest, projection.before, 1e-9);
}

TEST(Projection, AStrokeInOneDirectionIsNoSecondParameter) {
  const auto records = testing::records_of({{.frequency_Hz = 0.1, .duration_s = 2}});
  const NoiseModel noise = testing::usual_noise(records);
  const Projection projection = project(gram_of(records, testing::kMu, noise, 0), noise);
  EXPECT_TRUE(projection.left.allFinite());
  EXPECT_NEAR(projection.left(1, 1) / projection.before(1, 1), 0, 1e-9);
}

}  // namespace
}  // namespace host_sim::diagnose
