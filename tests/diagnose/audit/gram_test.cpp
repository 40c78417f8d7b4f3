#include "host_sim/diagnose/audit/gram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/diagnose/audit/sessions.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Session> few_sessions() {
  return testing::sessions_of({{.bend_angle_rad = 1.5, .start_cycle = 10, .duration_s = 1},
                               {.bend_angle_rad = 3, .mean_N = 40, .duration_s = 2}});
}

/// The sum of c(t) d(t) over the samples, column by column and term by term.
double product(const Eigen::MatrixXd& columns, Eigen::Index one, Eigen::Index other) {
  double sum = 0;
  for (Eigen::Index t = 0; t < columns.rows(); ++t) {
    sum += columns(t, one) * columns(t, other);
  }
  return sum;
}

void expect_products(const Eigen::MatrixXd& gram, const Eigen::MatrixXd& columns) {
  ASSERT_EQ(gram.rows(), columns.cols());
  for (Eigen::Index i = 0; i < gram.rows(); ++i) {
    for (Eigen::Index j = 0; j < gram.cols(); ++j) {
      const double scale = columns.col(i).norm() * columns.col(j).norm();
      ASSERT_NEAR(gram(i, j), product(columns, i, j), 1e-12 * scale) << i << ' ' << j;
    }
  }
}

TEST(GramLayout, HasTheColumnsOfEachShapeOnceOneAfterTheOther) {
  const GramLayout layout = layout_of(few_sessions(), testing::baseline());
  std::size_t next = GramLayout::kFirstSignature;
  for (const GramLayout::Effect& effect : layout.effects) {
    for (const GramLayout::Block& block : effect.blocks) {
      EXPECT_EQ(block.first, next) << effect.effect->id();
      next += block.count;
    }
  }
  EXPECT_EQ(layout.size, next);
  const GramLayout::Effect& position = layout.of("friction_position");
  ASSERT_EQ(position.blocks.size(), 6U);
  EXPECT_EQ(position.blocks[1].count, 16U);
  EXPECT_THAT(position.blocks[1].shape, ElementsAre(0.02));
  EXPECT_THROW(static_cast<void>(layout.of("no_such_effect")), std::out_of_range);
}

TEST(GramLayout, LeavesOutWhatOneSessionCannotGive) {
  std::vector<Session> sessions = few_sessions();
  sessions[1].covariates.sheath_temperature_C.clear();
  const GramLayout layout = layout_of(sessions, testing::baseline());
  EXPECT_TRUE(layout.of("friction_temperature").blocks.empty());
  EXPECT_THAT(layout.of("friction_temperature").missing, HasSubstr("sheath_temperature_C"));
  EXPECT_EQ(layout.of("friction_wear").missing, "");
}

TEST(GramLayout, OfNoSessionsHasNoSignatures) {
  const GramLayout layout = layout_of({}, testing::baseline());
  EXPECT_EQ(layout.size, GramLayout::kFirstSignature);
  EXPECT_THAT(layout.of("slack").missing, HasSubstr("recordings"));
}

TEST(Poses, CountAnglesWithinADegreeAsOne) {
  const std::vector<Session> sessions =
      testing::sessions_of({{.bend_angle_rad = 3, .duration_s = 1},
                            {.bend_angle_rad = 1.5, .duration_s = 1},
                            {.bend_angle_rad = 3.01, .duration_s = 1},
                            {.bend_angle_rad = 3.1, .duration_s = 1}});
  EXPECT_THAT(poses_of(sessions),
              ElementsAre(DoubleNear(1.5, 1e-12), DoubleNear(3, 1e-12), DoubleNear(3.1, 1e-12)));
}

TEST(Columns, StartWithInterceptAndFriction) {
  std::vector<Session> sessions = few_sessions();
  sessions[0].covariates.direction[4] = -1;
  sessions[0].covariates.direction[5] = 1;
  const GramLayout layout = layout_of(sessions, testing::baseline());
  const Eigen::MatrixXd columns = columns_of(sessions[0], layout, testing::baseline());
  EXPECT_EQ(columns(4, 0), 1);
  EXPECT_EQ(columns(4, 1), 1.5);
  EXPECT_EQ(columns(5, 1), -1.5);
}

TEST(Gram, IsAllInnerProductsOfASession) {
  std::vector<Session> sessions = few_sessions();
  sessions[1].covariates.output_tension_N[9] *= 1.1;
  const Grams grams = gram_of(sessions, {.baseline = testing::baseline()});
  ASSERT_EQ(grams.sessions.size(), 2U);
  ASSERT_EQ(grams.baseline.poses_rad.size(), 2U);
  for (std::size_t s = 0; s < 2; ++s) {
    expect_products(grams.sessions[s], columns_of(sessions[s], grams.layout, grams.baseline));
  }
}

TEST(Gram, WhitensBeforeItSums) {
  const std::vector<Session> sessions = few_sessions();
  const Grams grams = gram_of(sessions, {.baseline = testing::baseline(), .autocorrelation = 0.6});
  const Eigen::MatrixXd plain = columns_of(sessions[0], grams.layout, grams.baseline);
  Eigen::MatrixXd expected = plain;
  expected.row(0) = 0.8 * plain.row(0);
  for (Eigen::Index t = 1; t < plain.rows(); ++t) {
    expected.row(t) = plain.row(t) - 0.6 * plain.row(t - 1);
  }
  expect_products(grams.sessions[0], expected);
}

TEST(Gram, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Session> sessions = testing::sessions_of(testing::one_pose());
  const Grams one = gram_of(sessions, {.baseline = testing::baseline(), .threads = 1});
  const Grams three = gram_of(sessions, {.baseline = testing::baseline(), .threads = 3});
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    EXPECT_TRUE(one.sessions[s] == three.sessions[s]) << s;
  }
}

}  // namespace
}  // namespace host_sim::diagnose
