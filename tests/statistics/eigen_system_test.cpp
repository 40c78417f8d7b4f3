#include "host_sim/statistics/eigen_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim::statistics {
namespace {

TEST(EigenSystem, OfAMatrixByHand) {
  // (2 - v)^2 = 1, along (1, -1) and (1, 1).
  const EigenSystem system = eigen_system(Eigen::Matrix2d{{2, 1}, {1, 2}});
  EXPECT_NEAR(system.values(0), 1, 1e-15);
  EXPECT_NEAR(system.values(1), 3, 1e-15);
  EXPECT_NEAR(std::abs(system.vectors(0, 0)), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(system.vectors(1, 0), -system.vectors(0, 0), 1e-15);
  EXPECT_NEAR(std::abs(system.vectors(0, 1)), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(system.vectors(1, 1), system.vectors(0, 1), 1e-15);
}

TEST(EigenSystem, ReadsTheLowerTriangle) {
  const EigenSystem system = eigen_system(Eigen::Matrix2d{{2, 77}, {1, 2}});
  EXPECT_NEAR(system.values(0), 1, 1e-15);
  EXPECT_NEAR(system.values(1), 3, 1e-15);
}

}  // namespace
}  // namespace host_sim::statistics
