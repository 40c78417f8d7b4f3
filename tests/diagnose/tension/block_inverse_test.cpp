#include "host_sim/diagnose/tension/block_inverse.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

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

}  // namespace
}  // namespace host_sim::diagnose
