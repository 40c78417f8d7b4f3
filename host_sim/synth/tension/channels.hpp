#pragma once

#include <array>
#include <vector>

#include "host_sim/io/profile_columns.hpp"

namespace host_sim::synth {

/// What is recorded in one session, by ProfileColumnId, in the unit of each column.
using Channels = std::array<std::vector<double>, kProfileColumnCount>;

}  // namespace host_sim::synth
