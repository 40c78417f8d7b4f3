#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/signal.hpp"

/// Names of the values of the enumerations in messages.hpp.
namespace protocol::schema {

template <class Enum>
constexpr ValueName name_of(Enum value, std::string_view name) {
  return {.value = static_cast<std::uint32_t>(value), .name = name};
}

inline constexpr std::array kNmtStates{
    name_of(NmtState::boot_up, "boot_up"),
    name_of(NmtState::stopped, "stopped"),
    name_of(NmtState::operational, "operational"),
};

inline constexpr std::array kLifeStates{
    name_of(LifeState::unknown, "unknown"), name_of(LifeState::normal, "normal"),
    name_of(LifeState::inspect, "inspect"), name_of(LifeState::replace, "replace"),
    name_of(LifeState::worn, "worn"),
};

inline constexpr std::array kQualities{
    name_of(Quality::measured, "measured"),   name_of(Quality::gaps, "gaps"),
    name_of(Quality::bounded, "bounded"),     name_of(Quality::saturated, "saturated"),
    name_of(Quality::untrusted, "untrusted"),
};

inline constexpr std::array kEmergencyCodes{
    name_of(EmergencyCode::none, "none"),
    name_of(EmergencyCode::emergency_stop, "emergency_stop"),
    name_of(EmergencyCode::life_inspect, "life_inspect"),
    name_of(EmergencyCode::life_replace, "life_replace"),
    name_of(EmergencyCode::life_worn, "life_worn"),
    name_of(EmergencyCode::overload, "overload"),
    name_of(EmergencyCode::sensor, "sensor"),
    name_of(EmergencyCode::storage, "storage"),
    name_of(EmergencyCode::record_damaged, "record_damaged"),
    name_of(EmergencyCode::parameters, "parameters"),
    name_of(EmergencyCode::bus, "bus"),
    name_of(EmergencyCode::deadline, "deadline"),
    name_of(EmergencyCode::authority, "authority"),
};

inline constexpr std::array kCommandCodes{
    name_of(CommandCode::identify, "identify"),
    name_of(CommandCode::select_page, "select_page"),
    name_of(CommandCode::burst, "burst"),
};

inline constexpr std::array kCycleRateUnknown{
    ValueName{.value = detail::Cycles::kUnknownRate, .name = "unknown"},
};

inline constexpr std::array kDamageRateUnknown{
    ValueName{.value = detail::DamageRate::kUnknownRate, .name = "unknown"},
};

inline constexpr std::array kRemainingLifeUnknown{
    ValueName{.value = detail::RemainingLife::kUnknown, .name = "unknown"},
};

}  // namespace protocol::schema
