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

/// What an effect may be written in terms of.
enum class Covariate : std::uint8_t { velocity = 1, rotor, sheath, winding };

constexpr const char* to_string(Covariate covariate) {
  switch (covariate) {
    case Covariate::velocity:
      return "the velocity of the tendon";
    case Covariate::rotor:
      return "the angle of the rotor";
    case Covariate::sheath:
      return "the temperature of the sheath";
    case Covariate::winding:
      return "the temperature of the winding";
  }
  return "unknown";
}

/// An effect that a controller cannot evaluate: it acts on the input, and this is not measured.
struct Unmet {
  const char* effect;
  std::uint8_t number;  ///< of the effect; kInputItself where the input alone needs it
  Covariate covariate;

  static constexpr std::uint8_t kInputItself = 0xff;
};

/// The first effect of an extension that acts on the input and needs what is not measured. An
/// output tension needs the velocity for its direction, whatever the effects.
constexpr std::optional<Unmet> unmet(const Extension& extension, Input input,
                                     const Measured& measured) {
  const auto lacks = [&](Effect effect, bool is_measured) {
    return extension.has(effect) && !is_measured;
  };
  const auto needs = [](const char* name, Effect effect, Covariate covariate) {
    return Unmet{name, static_cast<std::uint8_t>(effect), covariate};
  };
  if (input == Input::motor_current) {
    if (lacks(Effect::gear_asymmetry, measured.velocity)) {
      return needs("gear_asymmetry", Effect::gear_asymmetry, Covariate::velocity);
    }
    if (lacks(Effect::torque_ripple, measured.rotor)) {
      return needs("torque_ripple", Effect::torque_ripple, Covariate::rotor);
    }
    if (lacks(Effect::torque_gain, measured.winding)) {
      return needs("torque_gain", Effect::torque_gain, Covariate::winding);
    }
  }
  if (input == Input::output_tension) {
    if (!measured.velocity) {
      return Unmet{"the output tension", Unmet::kInputItself, Covariate::velocity};
    }
    if (lacks(Effect::friction_position, measured.rotor)) {
      return needs("friction_position", Effect::friction_position, Covariate::rotor);
    }
    if (lacks(Effect::friction_temperature, measured.sheath)) {
      return needs("friction_temperature", Effect::friction_temperature, Covariate::sheath);
    }
    const bool over_position = extension.empirical.covariate == Empirical::position;
    if (over_position && lacks(Effect::empirical, measured.rotor)) {
      return needs("empirical", Effect::empirical, Covariate::rotor);
    }
  }
  return std::nullopt;
}

}  // namespace lifemodel::extension
