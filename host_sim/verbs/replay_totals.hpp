#pragma once

#include <ostream>
#include <vector>

#include "host_sim/batch/run_batch.hpp"

namespace host_sim {

/// What a table of profiles shows, in a few lines for people. Lives of different cables are not
/// added up.
void write_totals(std::ostream& out, const std::vector<batch::Answer>& answers);

}  // namespace host_sim
