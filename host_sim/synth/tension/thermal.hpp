#pragma once

namespace host_sim::synth {

/// The two bodies that warm up: each is a first-order process.
struct Thermal {
  double room_C = 20;
  double sheath_time_constant_s = 10;
  double sheath_K_per_W = 0;  ///< by the power that friction turns into heat
  double winding_time_constant_s = 15;
  double winding_K_per_W = 5;
  double winding_resistance_ohm = 1;  ///< at the room's temperature
};

/// Temperature after `step_s` on the way to `end_C`, exact for an end that stands still.
double temperature_after(double now_C, double end_C, double step_s, double time_constant_s);

/// Watts that a current turns into heat: I^2 R, with the resistance of copper at the winding's
/// temperature.
double winding_heat(double current_A, double winding_C, const Thermal& thermal);

}  // namespace host_sim::synth
