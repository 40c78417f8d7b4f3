#include <gtest/gtest.h>

#include <cmath>

#include "lifemodel/input/capstan.hpp"
#include "lifemodel/input/motor_drive.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using lifemodel_test::to_newtons;
using pack::from_double;
using pack::to_double;

TEST(MotorDrive, TensionIsTorqueOverTheSpool) {
  auto constants = paper_constants();
  constants.current_offset_A = 0.25;
  const auto drive = parameters_of(constants).drive;
  Flags flags;
  // 0.0325 Nm/A * 2 A * 9 * 0.88 / 0.0125 m = 41.184 N
  EXPECT_NEAR(to_newtons(drive.tension(from_double<MotorCurrent>(2.25), flags)), 41.184, 2e-6);
  EXPECT_NEAR(to_newtons(drive.tension(from_double<MotorCurrent>(0.25), flags)), 0, 1e-9);
  EXPECT_NEAR(to_newtons(drive.tension(from_double<MotorCurrent>(-1.75), flags)), -41.184, 2e-6);
  EXPECT_TRUE(flags.none());
}

TEST(MotorDrive, EveryGainKeepsNineDigits) {
  for (const double gain : {1e-3, 0.02, 1.0, 20.592, 999.0, 5e4}) {
    auto constants = paper_constants();
    constants.tension_per_current_N_A = gain;
    const auto drive = parameters_of(constants).drive;
    const double current_A = std::min(100.0, 600 / gain);
    Flags flags;
    const double tension_N = to_newtons(drive.tension(from_double<MotorCurrent>(current_A), flags));
    const double half_step_N = 1e-6;
    EXPECT_NEAR(tension_N, gain * current_A,
                half_step_N + gain * std::ldexp(1, -24) + 1e-9 * tension_N);
    EXPECT_TRUE(flags.none());
  }
}

TEST(TensionScale, MillinewtonsOfAnyWire) {
  for (const double ultimate_N : {1.0, 177.4, 2500.0, 1e6}) {
    auto constants = paper_constants();
    constants.ultimate_tension_N = ultimate_N;
    constants.ipl_scale = std::pow(ultimate_N, 1.38) * 100;
    const auto scale = parameters_of(constants).scale;
    Flags flags;
    for (const int tension_mN : {0, 1, -1, 900, -3999}) {
      EXPECT_NEAR(to_double(scale.tension(tension_mN, flags)), tension_mN * 1e-3 / ultimate_N,
                  2e-9);
    }
    EXPECT_TRUE(flags.none());
  }
  Flags flags;
  EXPECT_EQ(parameters_of(paper_constants()).scale.tension(800'000, flags), Tension::highest());
  EXPECT_TRUE(flags.has(Flag::saturated));
}

TEST(MotorDrive, SaturatesWithTheFlag) {
  const auto drive = parameters_of(paper_constants()).drive;
  Flags flags;
  EXPECT_EQ(drive.tension(from_double<MotorCurrent>(120), flags), Tension::highest());
  EXPECT_TRUE(flags.has(Flag::saturated));
}

TEST(Capstan, FrictionAddsWhilePullingAndTakesWhileReleasing) {
  const auto parameters = parameters_of(paper_constants());
  Flags flags;
  // mu phi = 0.128 * 3 pi / 2 = 0.603186; exp(0.603186) = 1.827933, 49 N * 1.827933 = 89.5687 N
  const double pull_N = to_newtons(
      parameters.capstan.input_tension(newtons(49), parameters.bend, Direction::pulling, flags));
  const double release_N = to_newtons(
      parameters.capstan.input_tension(newtons(49), parameters.bend, Direction::releasing, flags));
  EXPECT_NEAR(pull_N, 89.5687, 5e-4);
  EXPECT_NEAR(release_N, 26.8062, 5e-4);
  EXPECT_NEAR(pull_N * release_N, 49.0 * 49.0, 1e-3);
  EXPECT_TRUE(flags.none());
}

TEST(Capstan, StatedErrorOverAllAngles) {
  for (const double friction : {0.0, 0.05, 0.128, 0.45, 1.0}) {
    auto constants = paper_constants();
    constants.friction_coefficient = friction;
    const auto capstan = parameters_of(constants).capstan;
    for (double bend_rad = 0; bend_rad <= 31.4; bend_rad += 0.37) {
      for (const auto direction : {Direction::pulling, Direction::releasing}) {
        Flags flags;
        const double sign = direction == Direction::pulling ? 1 : -1;
        const double exact_N = 3.0 * std::exp(sign * friction * bend_rad);
        const double ours_N = to_newtons(
            capstan.input_tension(newtons(3), from_double<Angle>(bend_rad), direction, flags));
        if (exact_N > 4 * lifemodel_test::kUltimate_N) {
          EXPECT_TRUE(flags.has(Flag::saturated));
          EXPECT_GT(ours_N, 709);
        } else {
          EXPECT_NEAR(ours_N, exact_N, 4e-7 * exact_N + 1e-6);
        }
      }
    }
  }
}

TEST(Capstan, SaturatesHoweverLargeTheFriction) {
  auto constants = paper_constants();
  constants.friction_coefficient = 1;
  const auto capstan = parameters_of(constants).capstan;
  for (const Tension output : {Tension::highest(), Tension::from_raw(1 << 20)}) {
    Flags flags;
    EXPECT_EQ(capstan.input_tension(output, Angle::highest(), Direction::pulling, flags),
              Tension::highest());
    EXPECT_TRUE(flags.has(Flag::saturated));
    EXPECT_EQ(capstan.input_tension(Tension::from_raw(-output.raw()), Angle::highest(),
                                    Direction::pulling, flags),
              Tension::lowest());
  }
}

TEST(Capstan, NothingInNothingOut) {
  const auto parameters = parameters_of(paper_constants());
  Flags flags;
  EXPECT_EQ(
      parameters.capstan.input_tension(Tension{}, Angle::highest(), Direction::pulling, flags),
      Tension{});
  EXPECT_TRUE(flags.none());
}

}  // namespace
}  // namespace lifemodel
