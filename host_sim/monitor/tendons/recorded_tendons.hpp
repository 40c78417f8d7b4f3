#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/fleet/fleet_table.hpp"
#include "host_sim/fleet/horizon.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// What `monitor --record` wrote to one folder, or one log.
struct Record {
  std::string name;
  std::vector<std::filesystem::path> logs;  ///< the oldest first
  bool rotated = false;                     ///< of `monitor --record`, which may still write
};

/// The records of a folder: its own logs, those of each folder in it, and each other log in it, by
/// name.
/// @throws InputError where there are none
std::vector<Record> records_in(const std::filesystem::path& folder);

/// What a record shows of one tendon.
struct RecordedTendon {
  std::string name;  ///< record/node/tendon
  double damage = 0;
  double damage_per_h = 0;      ///< gained while it was heard, over the hours
  double rate_log_sd = 0;       ///< of ln of the rates of its sessions, weighted by their hours
  std::optional<double> age_h;  ///< heard, where all of its damage was gained meanwhile
  std::int64_t last_ns = 0;     ///< when its damage was reported last
  std::optional<bool> broken;   ///< none where one of its controller is, and not known which
  bool past_lost = false;       ///< the controller does not vouch for its damage
};

/// The tendons that frames report of, in the order of node and tendon. A session begins where the
/// node starts, or after kSilence_ns without a report; its first report counts as what was there
/// before.
/// @param next gives the frames, the oldest first
/// @param name stands for the record in names and errors
/// @throws InputError for frames that show no damage of a tendon, no rate, or two controllers with
/// one id
std::vector<RecordedTendon> recorded_tendons(const std::function<std::optional<SeenFrame>()>& next,
                                             std::string_view name);

inline constexpr std::int64_t kSilence_ns = std::int64_t{600} * 1'000'000'000;
/// Shorter sessions say nothing of the scatter of the rate.
inline constexpr double kShortestSession_h = 0.1;

/// The tendons of records, to be planned for.
struct RecordedFleet {
  std::vector<fleet::TendonRow> rows;  ///< those that are whole
  std::vector<std::string> broken;     ///< names of those that are not
  std::vector<std::string> doubts;     ///< sentences
};

/// @throws InputError, Interruption
RecordedFleet read_records(const std::filesystem::path& folder, const std::vector<Record>& records,
                           double hours_per_day, fleet::Date today);

}  // namespace host_sim::monitor
