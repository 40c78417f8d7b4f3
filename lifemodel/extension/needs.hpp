#pragma once

#include <cstdint>
#include <optional>

#include "lifemodel/extension/empirical.hpp"
#include "lifemodel/extension/extension.hpp"

namespace lifemodel::extension {

/// What a controller samples of the load.
enum class Input : std::uint8_t { input_tension, motor_current, output_tension };

/// What it measures besides.
struct Measured {
  bool velocity = false;
  bool rotor = false;
  bool sheath = false;   ///< temperature
  bool winding = false;  ///< temperature
};

/// An effect that a controller cannot evaluate: it acts on the input, and this is not measured.
struct Unmet {
  const char* effect;
  const char* quantity;
};

/// The first effect of an extension that acts on the input and needs what is not measured. An
/// output tension needs the velocity for its direction, whatever the effects.
constexpr std::optional<Unmet> unmet(const Extension& extension, Input input,
                                     const Measured& measured) {
  constexpr const char* kVelocity = "the velocity of the tendon";
  constexpr const char* kRotor = "the angle of the rotor";
  constexpr const char* kSheath = "the temperature of the sheath";
  constexpr const char* kWinding = "the temperature of the winding";
  const auto lacks = [&](Effect effect, bool is_measured) {
    return extension.has(effect) && !is_measured;
  };
  if (input == Input::motor_current) {
    if (lacks(Effect::gear_asymmetry, measured.velocity)) {
      return Unmet{"gear_asymmetry", kVelocity};
    }
    if (lacks(Effect::torque_ripple, measured.rotor)) {
      return Unmet{"torque_ripple", kRotor};
    }
    if (lacks(Effect::torque_gain, measured.winding)) {
      return Unmet{"torque_gain", kWinding};
    }
  }
  if (input == Input::output_tension) {
    if (!measured.velocity) {
      return Unmet{"the output tension", kVelocity};
    }
    if (lacks(Effect::friction_position, measured.rotor)) {
      return Unmet{"friction_position", kRotor};
    }
    if (lacks(Effect::friction_temperature, measured.sheath)) {
      return Unmet{"friction_temperature", kSheath};
    }
    const bool over_position = extension.empirical.covariate == Empirical::position;
    if (over_position && lacks(Effect::empirical, measured.rotor)) {
      return Unmet{"empirical", kRotor};
    }
  }
  return std::nullopt;
}

}  // namespace lifemodel::extension
