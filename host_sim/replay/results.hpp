#pragma once

#include <ostream>
#include <string>

#include "host_sim/replay/replay.hpp"

namespace host_sim {

/// The result as JSON, one object with the fields of the file format; what is infinite is null.
std::string replay_json(const ReplayResult& result);

/// The result in a few lines for people.
void write_summary(std::ostream& out, const ReplayResult& result, const std::string& profile_name,
                   const std::string& model_name);

/// Fills the numbers of a report, everything but its plots.
void fill_report(ReplayReport& report, const ReplayResult& result, const Model& model);

}  // namespace host_sim
