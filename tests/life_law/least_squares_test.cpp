#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::life_law {
namespace {

constexpr std::array kAlpha{854.0, 675.0, 551.0, 407.0};  // the paper's Table 4, 315 to 450 deg

// The paper has 1.53e5, 1.38 and 12.3. Its Table 4 gives these, with the mean of the squares over
// the four levels: over two degrees of freedom it would be 17.9.
TEST(LeastSquaresFit, OfThePapersTable4) {
  constexpr std::array kTension_N{42.5, 50.7, 60.0, 70.8};
  const LeastSquares fit = fit_least_squares(kTension_N, kAlpha);
  EXPECT_NEAR(fit.scale, 1.54e5, 0.005e5);
  EXPECT_NEAR(fit.exponent, 1.384, 0.0005);
  EXPECT_NEAR(fit.rmse_cycles, 12.6, 0.05);
}

TEST(LeastSquaresFit, OfAPowerLawIsThatLaw) {
  constexpr std::array kTension_N{10.0, 20.0, 40.0};
  constexpr std::array kLives{1000.0, 250.0, 62.5};
  const LeastSquares fit = fit_least_squares(kTension_N, kLives);
  EXPECT_NEAR(fit.scale, 1e5, 1e-6);
  EXPECT_NEAR(fit.exponent, 2, 1e-11);
  EXPECT_NEAR(fit.rmse_cycles, 0, 1e-9);
}

// Errors are in cycles, not in their logarithms: the slopes of the sum of squares vanish.
TEST(LeastSquaresFit, NoSlopeIsLeft) {
  constexpr std::array kTension_N{42.5, 50.7, 60.0, 70.8};
  const LeastSquares fit = fit_least_squares(kTension_N, kAlpha);
  double by_scale = 0;
  double by_exponent = 0;
  double squares = 0;
  for (std::size_t i = 0; i < kAlpha.size(); ++i) {
    const double life = fit.scale / std::pow(kTension_N[i], fit.exponent);
    const double error = kAlpha[i] - life;
    by_scale += error * life;
    by_exponent += error * life * std::log(kTension_N[i]);
    squares += error * error;
  }
  EXPECT_NEAR(by_scale, 0, 1e-6);
  EXPECT_NEAR(by_exponent, 0, 1e-6);
  EXPECT_NEAR(fit.rmse_cycles, std::sqrt(squares / 4), 1e-9);
}

}  // namespace
}  // namespace host_sim::life_law
