#pragma once

#include <span>
#include <string_view>

#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/situation.hpp"

namespace blind {

/// Which sensor at the drive's end must tell the tension for an effect to be seen.
enum class Needs { any_input, load_cell, motor_current };

struct SizedEffect {
  std::string_view id;
  Needs needs;
  HiddenEffect (*draw)(const Situation& situation, Dice& dice);
};

/// Effects of the catalogue on friction, on the transmission, and on drive and sensors; departures
/// that it does not have.
std::span<const SizedEffect> friction_effects();
std::span<const SizedEffect> transmission_effects();
std::span<const SizedEffect> sensor_effects();
std::span<const SizedEffect> outside_effects();

}  // namespace blind
