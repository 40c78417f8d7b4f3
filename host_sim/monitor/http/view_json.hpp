#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/monitor/fleet/node_view.hpp"
#include "host_sim/monitor/record/moment.hpp"

/// Views as JSON. Messages have the names and physical values of the frame plan, times are whole
/// microseconds, what is not known is left out; there is no null.
namespace host_sim::monitor {

/// The bus and every node without its history.
nlohmann::json fleet_json(const FleetView& fleet);

/// What is known now.
nlohmann::json node_json(const NodeView& node);

/// Events and the damage curve, oldest first:
/// {"events": [..], "curve": [[time_us, damage, rate per hour], [time_us, damage], ..]}.
nlohmann::json history_json(const NodeView& node);

/// The fleet at a moment, and "from_us", the time from which on frames were read. A node that `now`
/// has and the frames have not is there as far as its history goes back: "partial", with damage,
/// rate and life state alone.
nlohmann::json moment_json(const Moment& moment, const FleetView& now);

/// "times_us", the moments that can be asked for: those of the archive, and before it those of the
/// damage curves, rising, FrameArchive::kMostTimes at most of each; "whole_from_us", the first of
/// the archive, before which nodes are partial; and `why_gone`, where there were frames before it.
nlohmann::json times_json(const std::vector<std::int64_t>& archived_us, const std::string& why_gone,
                          const FleetView& now);

/// The events that `after` has and `before` has not, by node: {"5": [event, ..]}.
nlohmann::json new_events(const FleetView& before, const FleetView& after);

/// What turns `before` into `after` (RFC 7396). @pre no null in `after`
nlohmann::json merge_patch(const nlohmann::json& before, const nlohmann::json& after);

/// One line. Bytes that are not UTF-8 become U+FFFD, numbers that are not finite null.
std::string json_text(const nlohmann::json& json);

/// The damage curve of a node: time_s,damage,damage_rate_per_h; the rate is empty where none is
/// known.
std::string history_csv(const NodeView& node);

}  // namespace host_sim::monitor
