#pragma once

#include <vector>

#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// At how many standard deviations an oracle sees each hidden effect of a campaign. Of recordings
/// it knows the exact trace that the effect leaves (the simulation with everything against that
/// without the effect, both without noise), the noise and the scatter of sessions, and estimates
/// the effect's size beside gain and friction coefficient by generalised least squares. Of lives
/// see life_visibility.hpp.
std::vector<double> visibility_of(const Scenario& scenario);

}  // namespace blind
