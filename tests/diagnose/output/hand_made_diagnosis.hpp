#pragma once

#include "host_sim/diagnose/diagnosis.hpp"

/// Diagnoses made by hand: what is in them is plausible, not computed.
namespace host_sim_test {

/// friction_wear with 0.987, one parameter; everything that recordings can have.
host_sim::diagnose::TensionDiagnosis wear_in_recordings();

/// lot_frailty with 0.973; everything that lives can have.
host_sim::diagnose::LifeDiagnosis lots_in_lives();

/// An effect that the catalogue lacks, with a term of its own.
host_sim::diagnose::TensionDiagnosis zero_of_rig();

host_sim::diagnose::Remainder left_over_position();

/// Wear in the recordings, lots in the lives, and a warning.
host_sim::diagnose::Diagnosis both_parts();

}  // namespace host_sim_test
