#include "host_sim/life_law/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace host_sim::life_law {
namespace {

// -(x^2 - 1)^2 - (y - 3)^2 bends up in x near zero.
void two_hills(const Eigen::VectorXd& at, Expansion& expansion) {
  const double x = at[0];
  const double y = at[1] - 3;
  expansion.reset(2);
  expansion.value = -std::pow(x * x - 1, 2) - y * y;
  expansion.gradient << -4 * x * (x * x - 1), -2 * y;
  expansion.hessian << 4 - 12 * x * x, 0, 0, -2;
}

TEST(Newton, ClimbsOutOfAValley) {
  for (const double x : {0.01, 0.3, -0.01}) {
    const Maximum maximum = maximise(two_hills, Eigen::Vector2d(x, -40));
    EXPECT_TRUE(maximum.converged);
    EXPECT_NEAR(maximum.at[0], x > 0 ? 1 : -1, 1e-9);
    EXPECT_NEAR(maximum.at[1], 3, 1e-9);
  }
}

// ln x - x has its maximum at 1; full steps from 30 lead below zero.
TEST(Newton, StaysWithinReach) {
  const auto hill = [](const Eigen::VectorXd& at, Expansion& expansion) {
    expansion.reset(1);
    expansion.value =
        at[0] > 0 ? std::log(at[0]) - at[0] : -std::numeric_limits<double>::infinity();
    expansion.gradient << 1 / at[0] - 1;
    expansion.hessian << -1 / (at[0] * at[0]);
  };
  const Maximum maximum = maximise(hill, Eigen::VectorXd::Constant(1, 30.0));
  EXPECT_TRUE(maximum.converged);
  EXPECT_NEAR(maximum.at[0], 1, 1e-9);
}

TEST(Newton, ASlopeWithoutATopDoesNotConverge) {
  const auto slope = [](const Eigen::VectorXd& at, Expansion& expansion) {
    expansion.reset(1);
    expansion.value = at[0];
    expansion.gradient << 1;
  };
  EXPECT_FALSE(maximise(slope, Eigen::VectorXd::Zero(1)).converged);
}

}  // namespace
}  // namespace host_sim::life_law
