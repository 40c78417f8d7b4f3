#pragma once

#include "host_sim/synth/tension/part.hpp"

namespace host_sim::synth {

/// The effects on tension, each in the file of its name.
TensionKind friction_wear();
TensionKind friction_temperature();
TensionKind friction_velocity();
TensionKind presliding();
TensionKind friction_load();
TensionKind friction_preload();
TensionKind friction_position();
TensionKind slack();
TensionKind compliance();
TensionKind current_offset();
TensionKind torque_gain();
TensionKind gear_asymmetry();
TensionKind bend_angle();
TensionKind torque_ripple();
TensionKind filter_lag();
TensionKind undersampling();

/// Departures that no catalogue of effects names, in the folder outside.
TensionKind sheath_creep();
TensionKind stick_slip();
TensionKind load_cell_cross_talk();
TensionKind humidity_cycle();
TensionKind tension_dependent_bend();
TensionKind load_cell_thermal_lag();
TensionKind rotor_inertia();

}  // namespace host_sim::synth
