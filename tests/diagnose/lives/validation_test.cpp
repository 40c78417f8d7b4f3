#include "host_sim/diagnose/lives/validation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace host_sim::diagnose::lives {
namespace {

// z = ln(1.136) / (0.2 / sqrt(10)) = 2.0162, two-sided 0.0438.
TEST(ValidationPower, PIsThatOfTheNormalApproximation) {
  const ValidationPower power{10, std::log(1.136), 0.2, 0};
  EXPECT_NEAR(power.p(), 0.0438, 1e-4);
}

// (1.95996 + 0.84162)^2 0.2^2 / ln(1.136)^2 = 0.313954 / 0.016260 = 19.31.
TEST(ValidationPower, NeedsTheSpecimensOf80PercentAt5Percent) {
  const ValidationPower power{10, std::log(1.136), 0.2, 0};
  EXPECT_EQ(power.specimens_needed(), 20U);
}

// With 0.04 of the law: 0.04 / (0.016260 / 7.84886 - 0.0016) = 0.04 / 0.00047163 = 84.8.
TEST(ValidationPower, NeedsMoreWhereTheLawIsUncertain) {
  const ValidationPower power{10, std::log(1.136), 0.2, 0.04};
  EXPECT_EQ(power.specimens_needed(), 85U);
}

// wanted sd is 0.12751 / 2.80158 = 0.0455: the law alone has more.
TEST(ValidationPower, NoNumberIsEnoughForALawThatIsNotKnown) {
  const ValidationPower power{10, std::log(1.136), 0.2, 0.05};
  EXPECT_EQ(power.specimens_needed(), 0U);
}

}  // namespace
}  // namespace host_sim::diagnose::lives
