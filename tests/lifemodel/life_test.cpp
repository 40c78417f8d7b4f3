#include <gtest/gtest.h>

#include <cmath>

#include "lifemodel/life/weibull.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::damage_of;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using pack::to_double;

TEST(LifeDistribution, SurvivalIsWeibull) {
  for (const double shape : {0.5, 1.0, 2.1, 5.94, 50.0}) {
    auto constants = paper_constants();
    constants.weibull_shape = shape;
    const auto life = parameters_of(constants).life;
    for (double damage = 1e-6; damage < 200; damage *= 1.13) {
      const double exact = std::exp(-std::pow(damage, shape));
      EXPECT_NEAR(to_double(life.survival(damage_of(damage))), exact, 4e-6)
          << "shape " << shape << " damage " << damage;
    }
  }
}

TEST(LifeDistribution, NewAndWornOut) {
  const auto life = parameters_of(paper_constants()).life;
  EXPECT_EQ(life.survival(Damage{}), Ratio::highest());
  EXPECT_EQ(life.survival(Damage::from_words({1, 0, 0, 0})), Ratio::highest());
  EXPECT_EQ(life.survival(damage_of(1e6)), Ratio::lowest());
}

// (2^-104)^50 = 2^-5200.
TEST(LifeDistribution, TheSmallestDamageUnderTheLargestShapeIsNone) {
  auto constants = paper_constants();
  constants.weibull_shape = 50;
  const auto life = parameters_of(constants).life;
  EXPECT_EQ(life.survival(Damage::from_words({1, 0, 0, 0})), Ratio::highest());
}

TEST(LifeDistribution, PointsOfThePapersShape) {
  // beta 5.94: (-ln 0.9)^(1/5.94) = 0.684648, (ln 2)^(1/5.94) = 0.940163,
  // Gamma(1 + 1/5.94) = 0.927202, (-ln 0.1)^(1/5.94) = 1.150745
  const auto life = parameters_of(paper_constants()).life;
  EXPECT_NEAR(to_double(life.b10.damage()), 0.684648, 2e-5);
  EXPECT_NEAR(to_double(life.b50.damage()), 0.940163, 2e-5);
  EXPECT_NEAR(to_double(life.mean.damage()), 0.927202, 2e-5);
  EXPECT_NEAR(to_double(life.b90.damage()), 1.150745, 2e-5);
  EXPECT_NEAR(to_double(life.survival(life.b10.damage())), 0.9, 5e-6);
  EXPECT_NEAR(to_double(life.survival(life.b50.damage())), 0.5, 5e-6);
  EXPECT_NEAR(to_double(life.survival(life.b90.damage())), 0.1, 5e-6);
}

TEST(RemainingRepeats, CountsWholeRepeats) {
  const LifePoint one{1u << 28};
  EXPECT_EQ(remaining_repeats(Damage{}, damage_of(0.25), one), 4u);
  EXPECT_EQ(remaining_repeats(damage_of(0.5), damage_of(0.25), one), 2u);
  EXPECT_EQ(remaining_repeats(damage_of(0.5), damage_of(0.75), one), 0u);
  EXPECT_EQ(remaining_repeats(damage_of(1), damage_of(0.25), one), 0u);
  EXPECT_EQ(remaining_repeats(damage_of(3), damage_of(0.25), one), 0u);
  EXPECT_NEAR(remaining_repeats(Damage{}, damage_of(1e-6), one), 1e6, 1);
  EXPECT_NEAR(remaining_repeats(damage_of(0.1), damage_of(3e-9), one), 0.9 / 3e-9,
              0.9 / 3e-9 * 4e-7);
}

TEST(RemainingRepeats, SaturatesWhereNothingIsUsed) {
  const LifePoint one{1u << 28};
  EXPECT_EQ(remaining_repeats(Damage{}, Damage{}, one), 4294967295u);
  EXPECT_EQ(remaining_repeats(Damage{}, damage_of(1e-20), one), 4294967295u);
}

}  // namespace
}  // namespace lifemodel
