#pragma once

#include <cstddef>

#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// What the sizes of effects on tension are scaled by.
struct Situation {
  Input input = Input::load_cell;
  double friction_coefficient = 0;
  double gear_efficiency = 0;
  double mean_tension_N = 0;  ///< about the middle of all output tensions
  double shortest_travel_mm = 0;
  double last_cycle = 0;
  double fastest_m_s = 0;
  double rated_torque_Nm = 0;
  double full_scale_A = 0;
  std::size_t poses = 0;
};

}  // namespace blind
