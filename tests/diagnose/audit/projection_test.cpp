#include "host_sim/diagnose/audit/projection.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/diagnose/audit/sessions.hpp"
#include "tests/support/algebra.hpp"

namespace host_sim::diagnose {
namespace {

constexpr NoiseModel kSmallNoise{
    .sample_sd = 0.02, .session_gain_sd = 0.01, .session_friction_sd = 0.006};

std::vector<Session> three_poses() {
  return testing::sessions_of({{.bend_angle_rad = 1.5, .start_cycle = 10, .duration_s = 0.8},
                               {.bend_angle_rad = 3, .sheath_C = 40, .duration_s = 1},
                               {.bend_angle_rad = 4, .start_cycle = 900, .duration_s = 1.2}});
}

/// All sessions below one another: fine for a few samples.
Eigen::MatrixXd stacked(const std::vector<Session>& sessions, const Grams& grams) {
  Eigen::MatrixXd all(0, static_cast<Eigen::Index>(grams.layout.size));
  for (const Session& session : sessions) {
    const Eigen::MatrixXd columns = columns_of(session, grams.layout, grams.baseline);
    all.conservativeResize(all.rows() + columns.rows(), Eigen::NoChange);
    all.bottomRows(columns.rows()) = columns;
  }
  return all;
}

/// V of the header, whole.
Eigen::MatrixXd covariance(const std::vector<Session>& sessions, const NoiseModel& noise) {
  Eigen::Index size = 0;
  for (const Session& session : sessions) {
    size += static_cast<Eigen::Index>(session.covariates.samples());
  }
  Eigen::MatrixXd v = noise.sample_sd * noise.sample_sd * Eigen::MatrixXd::Identity(size, size);
  Eigen::Index first = 0;
  for (const Session& session : sessions) {
    const recording::Covariates& c = session.covariates;
    const auto count = static_cast<Eigen::Index>(c.samples());
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) {
        const auto a = static_cast<std::size_t>(i);
        const auto b = static_cast<std::size_t>(j);
        v(first + i, first + j) += noise.session_gain_sd * noise.session_gain_sd +
                                   noise.session_friction_sd * noise.session_friction_sd *
                                       c.bend_angle_rad[a] * c.direction[a] * c.bend_angle_rad[b] *
                                       c.direction[b];
      }
    }
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
  const std::vector<Session> sessions = three_poses();
  const Grams grams = gram_of(sessions, {.baseline = testing::baseline()});
  const Projection projection = project(grams, kSmallNoise);

  const Eigen::MatrixXd columns = stacked(sessions, grams);
  const Eigen::MatrixXd weighed = algebra::solved(covariance(sessions, kSmallNoise), columns);
  const Eigen::MatrixXd before = columns.transpose() * weighed;
  const Eigen::MatrixXd plain = columns.transpose() * columns / (0.02 * 0.02);
  expect_near(projection.before, before, plain, 1e-9);

  const Eigen::Matrix2d common = before.topLeftCorner<2, 2>();
  const Eigen::MatrixXd left =
      before - before.leftCols<2>() * common.inverse() * before.topRows<2>();
  expect_near(projection.left, left, plain, 1e-9);
}

TEST(Projection, WithoutScatterSessionsAreOne) {
  const std::vector<Session> sessions = three_poses();
  const Grams grams = gram_of(sessions, {.baseline = testing::baseline()});
  const NoiseModel noise{.sample_sd = 0.02, .session_gain_sd = 0, .session_friction_sd = 0};
  const Eigen::MatrixXd columns = stacked(sessions, grams);
  const Eigen::MatrixXd common = columns.leftCols<2>();
  const Eigen::MatrixXd rest = algebra::left_by(common, columns);
  const Projection projection = project(grams, noise);
  expect_near(projection.left, rest.transpose() * rest / (0.02 * 0.02), projection.before, 1e-9);
}

TEST(Projection, AStrokeInOneDirectionIsNoSecondParameter) {
  std::vector<Session> sessions = testing::sessions_of({{.frequency_Hz = 0.1, .duration_s = 2}});
  const Grams grams = gram_of(sessions, {.baseline = testing::baseline()});
  const Projection projection = project(grams, kSmallNoise);
  EXPECT_TRUE(projection.left.allFinite());
  EXPECT_NEAR(projection.left(1, 1) / projection.before(1, 1), 0, 1e-9);
}

}  // namespace
}  // namespace host_sim::diagnose
