#pragma once

#include "host_sim/synth/life/part.hpp"

namespace host_sim::synth {

/// The effects on life, each in the file of its name.
LifeKind mean_stress();
LifeKind bending_fatigue();
LifeKind endurance_limit();
LifeKind load_sequence();
LifeKind second_mode();
LifeKind lot_frailty();
LifeKind ageing();

/// Departures that no catalogue of effects names, in the folder outside.
LifeKind rig_bias();
LifeKind early_deaths();

}  // namespace host_sim::synth
