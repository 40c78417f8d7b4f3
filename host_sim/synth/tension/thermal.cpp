#include "host_sim/synth/tension/thermal.hpp"

#include <cmath>

namespace host_sim::synth {
namespace {

constexpr double kCopperPerKelvin = 0.00393;

}  // namespace

double temperature_after(double now_C, double end_C, double step_s, double time_constant_s) {
  return now_C + (end_C - now_C) * -std::expm1(-step_s / time_constant_s);
}

double winding_heat(double current_A, double winding_C, const Thermal& thermal) {
  const double resistance_ohm =
      thermal.winding_resistance_ohm * (1 + kCopperPerKelvin * (winding_C - thermal.room_C));
  return current_A * current_A * resistance_ohm;
}

}  // namespace host_sim::synth
