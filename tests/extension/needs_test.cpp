#include "lifemodel/extension/needs.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lifemodel::extension {
namespace {

std::string lacking(Effect effect, Input input, Measured measured) {
  Extension extension;
  extension.add(effect);
  const auto found = unmet(extension, input, measured);
  return found ? std::string(found->effect) + " needs " + to_string(found->covariate) : "";
}

constexpr Measured kAll{.velocity = true, .rotor = true, .sheath = true, .winding = true};

// The rows of lifemodel/extension/README.md.
TEST(Needs, AreThoseOfTheTable) {
  EXPECT_EQ(lacking(Effect::gear_asymmetry, Input::motor_current, {}),
            "gear_asymmetry needs the velocity of the tendon");
  EXPECT_EQ(lacking(Effect::torque_ripple, Input::motor_current, {.velocity = true}),
            "torque_ripple needs the angle of the rotor");
  EXPECT_EQ(lacking(Effect::torque_gain, Input::motor_current, {.sheath = true}),
            "torque_gain needs the temperature of the winding");
  EXPECT_EQ(lacking(Effect::friction_position, Input::output_tension, {.velocity = true}),
            "friction_position needs the angle of the rotor");
  EXPECT_EQ(lacking(Effect::friction_temperature, Input::output_tension,
                    {.velocity = true, .rotor = true, .winding = true}),
            "friction_temperature needs the temperature of the sheath");
  for (const Effect effect : {Effect::friction_wear, Effect::friction_velocity, Effect::presliding,
                              Effect::viscous_force, Effect::friction_load}) {
    EXPECT_EQ(lacking(effect, Input::output_tension, {.rotor = true, .sheath = true}),
              "the output tension needs the velocity of the tendon");
    EXPECT_EQ(lacking(effect, Input::output_tension, {.velocity = true}), "");
  }
}

TEST(Needs, OfACorrectionAreThoseOfItsCovariate) {
  Extension extension;
  extension.add(Effect::empirical);
  for (const auto covariate : {Empirical::travel, Empirical::output_tension, Empirical::speed}) {
    extension.empirical.covariate = covariate;
    EXPECT_FALSE(unmet(extension, Input::output_tension, {.velocity = true}));
  }
  extension.empirical.covariate = Empirical::position;
  EXPECT_STREQ(unmet(extension, Input::output_tension, {.velocity = true})->effect, "empirical");
  EXPECT_FALSE(unmet(extension, Input::output_tension, {.velocity = true, .rotor = true}));
}

TEST(Needs, AreOnlyThoseOfTheInput) {
  for (std::uint32_t number = 0; number < kEffects; ++number) {
    const auto effect = static_cast<Effect>(number);
    EXPECT_EQ(lacking(effect, Input::input_tension, {}), "") << number;
    EXPECT_EQ(lacking(effect, Input::motor_current, kAll), "") << number;
    EXPECT_EQ(lacking(effect, Input::output_tension, kAll), "") << number;
  }
  EXPECT_EQ(lacking(Effect::friction_temperature, Input::motor_current, {}), "");
  EXPECT_EQ(lacking(Effect::torque_gain, Input::output_tension, {.velocity = true}), "");
}

}  // namespace
}  // namespace lifemodel::extension
