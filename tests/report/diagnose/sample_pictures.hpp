#pragma once

#include "host_sim/diagnose/diagnosis.hpp"

/// Pictures of samples: what a tendon with a worn sheath, and lots that differ, would give.
namespace host_sim::samples {

/// Six sessions whose friction grows by `wear` times its nominal value from the first to the last.
void add_traces(diagnose::TensionDiagnosis& tension, double wear);

/// Residuals over the cycle, in proportion to `wear`, and over sheath temperature, without
/// structure; each pulling and letting go.
void add_remainders(diagnose::TensionDiagnosis& tension, double wear);

/// 48 lives at four levels in three lots, one of them suspended, whose means are `spread` apart in
/// ln N.
void add_points(diagnose::LifeDiagnosis& lives, double spread);

}  // namespace host_sim::samples
