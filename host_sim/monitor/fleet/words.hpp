#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// The names of the schema.
std::string_view name_of(protocol::LifeState state);
std::string_view name_of(protocol::Quality quality);
std::string_view name_of(protocol::NmtState state);
std::string_view name_of(protocol::EmergencyCode code);

/// The state of a node, of which two controllers are the gravest: "worn", "two_controllers".
std::string_view state_name(const NodeView& node);

/// What carries the damage of a node.
inline constexpr protocol::schema::Signal kDamageSignal =
    protocol::schema::signal_of(&protocol::LifeStatus::damage_ppb);

/// Damage or its rate, told in ppb by a signal, as per cent with as many digits as a ppb needs and
/// no more: "12.1", "0.0000001"; ">=429.4967295" at the end of its range.
std::string percent_of(std::uint32_t ppb, const protocol::schema::Signal& signal = kDamageSignal);

}  // namespace host_sim::monitor
