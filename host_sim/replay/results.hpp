#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "host_sim/replay/replay.hpp"

namespace host_sim {

/// The result as JSON, one object with the fields of the file format; what is infinite is null.
std::string replay_json(const ReplayResult& result);

/// The result in a few lines for people.
void write_summary(std::ostream& out, const ReplayResult& result, const std::string& profile_name,
                   const std::string& model_name);

/// Fills the numbers of a report, everything but its plots.
void fill_report(ReplayReport& report, const ReplayResult& result, const Model& model);

/// The header line of a table of profiles (RFC 4180); the columns have the names of the JSON result
/// with the names of its objects before them.
std::string replay_table_head();

/// The line of one profile; several flags, effects or warnings share a field.
std::string replay_table_row(std::string_view profile, std::string_view model,
                             const ReplayResult& result);

/// The line of a profile that was refused.
std::string refused_replay_row(std::string_view profile, std::string_view model,
                               std::string_view error);

}  // namespace host_sim
