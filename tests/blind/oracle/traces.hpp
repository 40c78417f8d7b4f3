#pragma once

#include <vector>

#include "host_sim/synth/tension/sensors.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// ln of output over input of each sample; input is a tension or a current, for gain takes up the
/// factor between them.
std::vector<double> log_ratio(const host_sim::synth::Channels& channels, Input input);

/// phi s of each sample; s is 1 while pulling, also before the first motion, and -1 while letting
/// go.
std::vector<double> signed_bend_rad(const host_sim::synth::Channels& channels);

}  // namespace blind
