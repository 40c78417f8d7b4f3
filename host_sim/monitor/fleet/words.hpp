#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "firmware/protocol/messages.hpp"

namespace host_sim::monitor {

/// The names of the schema.
std::string_view name_of(protocol::LifeState state);
std::string_view name_of(protocol::Quality quality);
std::string_view name_of(protocol::NmtState state);
std::string_view name_of(protocol::EmergencyCode code);

/// Damage as per cent, with as many digits as a ppb needs and no more: "12.1", "0.0000001".
std::string percent_of(std::uint32_t damage_ppb);

}  // namespace host_sim::monitor
