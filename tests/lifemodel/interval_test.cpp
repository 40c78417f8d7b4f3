#include "lifemodel/life/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/reference/equations.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::damage_of;
using pack::to_double;

std::uint32_t q21(double value) {
  return static_cast<std::uint32_t>(value * 0x1p21);
}

// Without ageing 10 % take 0.1053605 whatever was used, in proportion to life and load:
// hypot(1, 0.75) = 1.25, and 2^1.25 = 2.378414.
TEST(FurtherDamageInterval, OfAWireThatDoesNotAge) {
  const auto shape = pack::from_double<WeibullShape>(1);
  for (const double used : {0.01, 0.5, 3.0}) {
    const auto interval =
        further_damage_interval(shape, damage_of(used), kHazard10, {q21(1), 0, q21(0.75)});
    EXPECT_NEAR(to_double(interval.low), 0.1053605 / 2.378414, 1e-4 * 0.0443);
    EXPECT_NEAR(to_double(interval.high), 0.1053605 * 2.378414, 1e-4 * 0.2506);
  }
}

// The same in double precision: life and shape one at a time, their effects on the logarithm as the
// root of the sum of squares.
TEST(FurtherDamageInterval, AgreesWithDoublePrecision) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 20'000; ++i) {
    const auto shape = pack::from_double<WeibullShape>(0.8 * std::pow(15, uniform(random)));
    const double beta = to_double(shape);
    const Damage used = damage_of(1e-6 + 1.2 * uniform(random));
    const double life = 0.5 * uniform(random);
    const double width = 0.4 * uniform(random);
    const double load = uniform(random);
    const auto log2_of_variant = [&](double longer, double larger) {
      return std::log2(host_sim::reference::weibull_further_damage(
                 to_double(used) * std::exp2(-longer), 0.1, beta * std::exp2(larger))) +
             longer;
    };
    const double centre = log2_of_variant(0, 0);
    double below = load;
    double above = load;
    for (const auto& [one, other] :
         {std::pair{log2_of_variant(-life, 0), log2_of_variant(life, 0)},
          std::pair{log2_of_variant(0, -width), log2_of_variant(0, width)}}) {
      below = std::hypot(below, std::max({0.0, centre - one, centre - other}));
      above = std::hypot(above, std::max({0.0, one - centre, other - centre}));
    }
    const auto interval =
        further_damage_interval(shape, used, kHazard10, {q21(life), q21(width), q21(load)});
    ASSERT_NEAR(std::log2(to_double(interval.low)), centre - below, 1e-4) << beta;
    ASSERT_NEAR(std::log2(to_double(interval.high)), centre + above, 1e-4) << beta;
  }
}

// Five octaves of damage from the pivot the exponent adds 0.128 / 1.6 * 5 = 0.4: hypot(0.3, 0.4).
TEST(LifeSpread, GrowsAwayFromThePivot) {
  const auto exponent = pack::from_double<IplExponent>(1.6);
  const LifeUncertainty fit{.log2_life = q21(0.3),
                            .exponent = static_cast<std::uint32_t>(0.128 * 0x1p27),
                            .log2_shape = 0,
                            .log2_damage_at_pivot = -(10 << 21)};
  EXPECT_NEAR(life_spread(fit, exponent, -(5 << 21)) * 0x1p-21, 0.5, 1e-4);
  EXPECT_NEAR(life_spread(fit, exponent, -(15 << 21)) * 0x1p-21, 0.5, 1e-4);
  EXPECT_NEAR(life_spread(fit, exponent, -(10 << 21)) * 0x1p-21, 0.3, 1e-4);
}

}  // namespace
}  // namespace lifemodel
