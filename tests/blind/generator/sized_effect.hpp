#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// What the sizes of effects on tension are scaled by.
struct TensionScales {
  Input input = Input::load_cell;
  double friction_coefficient = 0;
  double gear_efficiency = 0;
  double mean_tension_N = 0;  ///< about the middle of all output tensions
  double shortest_travel_mm = 0;
  double last_cycle = 0;
  double fastest_m_s = 0;
  double fastest_m_s2 = 0;
  double force_amplitude_N = 0;  ///< of a drive that works in both directions
  double rated_torque_Nm = 0;
  double full_scale_A = 0;
  std::size_t poses = 0;
};

/// Which sensor at the drive's end must measure the tension for an effect to be seen.
enum class Needs { any_input, load_cell, motor_current };

struct SizedEffect {
  std::string_view id;
  Needs needs;
  HiddenEffect (*draw)(const TensionScales& scales, Dice& dice);
};

/// A time of 1 .. 20 ms of the sensor at either end.
HiddenEffect of_either_sensor(const char* id, const char* key, const TensionScales& scales,
                              Dice& dice);

/// Effects of the catalogue on friction, on the transmission, and on drive and sensors; departures
/// that it does not have.
std::span<const SizedEffect> friction_effects();
std::span<const SizedEffect> transmission_effects();
std::span<const SizedEffect> sensor_effects();
std::span<const SizedEffect> outside_effects();

/// More of these that seeds to tune with never draw.
std::span<const SizedEffect> held_back_effects();

/// The same of a drive that works in both directions.
std::span<const SizedEffect> two_sided_effects();
std::span<const SizedEffect> outside_two_sided_effects();
std::span<const SizedEffect> held_back_two_sided_effects();

}  // namespace blind
