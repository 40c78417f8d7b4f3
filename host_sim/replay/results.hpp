#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "host_sim/replay/replay.hpp"

namespace host_sim {

/// The result as JSON, one object with the fields of the file format; what is infinite is null.
std::string replay_json(const ReplayResult& result);

/// The header line of a specimens.csv that `calibrate` reads, and a row of it. The effective
/// tension stands as the cycle that is that tension: no mean, and it as the amplitude.
std::string specimens_head();
std::string specimen_row(std::string_view specimen, const SeenLife& life);

/// What is found in a profile and `--fail-on` knows: its flags, `tendon_broken`, `tendon_slack`.
std::vector<std::string> found_in(const ReplayResult& result);
std::vector<std::string> all_findings();

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
