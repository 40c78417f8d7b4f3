#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/frame.hpp"

/// The frames: the predefined connection set of CANopen (CiA 301, 7.3.3), classic CAN, 11 bits; the
/// names of values, and the layouts of the frames without pages.
namespace protocol::schema {

inline constexpr Frame kHeartbeatFrame{
    .name = "Heartbeat",
    .base_id = 0x700,
    .length = 1,
    .cycle_ms = 1000,
    .sent = "every 1 s, and boot_up once at the start",
    .comment = "NMT state (CiA 301, 7.2.8.3.2.2), not protected"};

inline constexpr Frame kLifeStatusFrame{.name = "LifeStatus",
                                        .base_id = 0x180,
                                        .length = 8,
                                        .cycle_ms = 100,
                                        .sent = "every 100 ms and on change, 10 ms apart at least",
                                        .comment = "The life of the node at a glance",
                                        .integrity = Integrity{.crc_byte = 0, .id_list = 0}};

inline constexpr Frame kLifeDetailFrame{
    .name = "LifeDetail",
    .base_id = 0x280,
    .length = 8,
    .cycle_ms = 100,
    .sent = "one page every 100 ms",
    .comment = "All that is worth a record, a page at a time",
    .integrity = Integrity{.crc_byte = 0, .id_list = 1},
    .page = Signal{.name = "Page", .start_bit = 12, .bits = 4, .comment = "which page follows"}};

inline constexpr Frame kEmergencyFrame{
    .name = "Emergency",
    .base_id = 0x080,
    .length = 8,
    .sent = "on every transition, at most 10 a second",
    .comment = "What needs attention, and when it is over (CiA 301, 7.2.7)",
    .integrity = Integrity{.crc_byte = 3, .id_list = 2}};

inline constexpr Frame kCommandFrame{
    .name = "Command",
    .base_id = 0x200,
    .length = 8,
    .sender = Sender::host,
    .sent = "on request",
    .comment = "Harmless requests, they change nothing but what is shown",
    .integrity = Integrity{.crc_byte = 0, .id_list = 3}};

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
    name_of(EmergencyCode::tendon_broken, "tendon_broken"),
    name_of(EmergencyCode::tendon_slack, "tendon_slack"),
    name_of(EmergencyCode::sensor, "sensor"),
    name_of(EmergencyCode::storage, "storage"),
    name_of(EmergencyCode::record_damaged, "record_damaged"),
    name_of(EmergencyCode::parameters, "parameters"),
    name_of(EmergencyCode::settings, "settings"),
    name_of(EmergencyCode::bus, "bus"),
    name_of(EmergencyCode::deadline, "deadline"),
    name_of(EmergencyCode::authority, "authority"),
};

inline constexpr std::array kWireEvents{
    name_of(WireEvent::above_50, "above_50"),
    name_of(WireEvent::above_70, "above_70"),
    name_of(WireEvent::above_90, "above_90"),
    name_of(WireEvent::slack, "slack"),
};

inline constexpr std::array kAdviceStates{
    name_of(AdviceState::off, "off"),
    name_of(AdviceState::unknown, "unknown"),
    name_of(AdviceState::no_limit, "no_limit"),
    name_of(AdviceState::limited, "limited"),
    name_of(AdviceState::unreachable, "unreachable"),
    name_of(AdviceState::over, "over"),
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

inline constexpr std::array kAdviceUnknown{
    ValueName{.value = detail::Advice::kUnknown, .name = "unknown"},
};

inline constexpr std::array kBreakRiskUnknown{
    ValueName{.value = detail::BreakRisk::kUnknownRisk, .name = "unknown"},
};

inline constexpr std::array kBoundUnknown{
    ValueName{.value = detail::BreakRisk::kUnknownBound, .name = "unknown"},
};

template <>
struct Layout<Heartbeat> {
  static constexpr const Frame& kFrame = kHeartbeatFrame;
  static constexpr std::string_view kName = kFrame.name;
  static constexpr std::string_view kComment = {};
  static constexpr std::tuple kFields{
      field(&Heartbeat::state, {.name = "NmtState",
                                .start_bit = 0,
                                .bits = 8,
                                .comment = "state of the node",
                                .values = kNmtStates}),
  };
};

template <>
struct Layout<LifeStatus> {
  static constexpr const Frame& kFrame = kLifeStatusFrame;
  static constexpr std::string_view kName = kFrame.name;
  static constexpr std::string_view kComment = {};
  static constexpr std::tuple kFields{
      field(&LifeStatus::state, {.name = "LifeState",
                                 .start_bit = 12,
                                 .bits = 4,
                                 .comment = "how far the life of the worst tendon is used",
                                 .values = kLifeStates}),
      field(&LifeStatus::damage_ppb, {.name = "Damage",
                                      .start_bit = 16,
                                      .bits = 32,
                                      .factor = "0.000000001",
                                      .comment = "of the worst tendon, 1 is its characteristic "
                                                 "life, stops at the end of its range",
                                      .stops = true}),
      field(&LifeStatus::worst_tendon, {.name = "WorstTendon",
                                        .start_bit = 48,
                                        .bits = 5,
                                        .comment = "which tendon that is, from 0"}),
      field(&LifeStatus::quality, {.name = "Quality",
                                   .start_bit = 53,
                                   .bits = 3,
                                   .comment = "how far the reading can be trusted",
                                   .values = kQualities}),
      field(&LifeStatus::storage_ok, {.name = "StorageOk",
                                      .start_bit = 56,
                                      .bits = 1,
                                      .comment = "the life record can be written"}),
      field(&LifeStatus::sensor_ok,
            {.name = "SensorOk", .start_bit = 57, .bits = 1, .comment = "every sensor works"}),
      field(&LifeStatus::gap,
            {.name = "Gap", .start_bit = 58, .bits = 1, .comment = "samples were missing"}),
      field(&LifeStatus::saturated, {.name = "Saturated",
                                     .start_bit = 59,
                                     .bits = 1,
                                     .comment = "a value met the end of its range"}),
      field(&LifeStatus::overrun, {.name = "Overrun",
                                   .start_bit = 60,
                                   .bits = 1,
                                   .comment = "cycles were counted larger than they were"}),
      field(&LifeStatus::locked, {.name = "Locked",
                                  .start_bit = 61,
                                  .bits = 1,
                                  .comment = "the drive is held off by the emergency stop"}),
      field(&LifeStatus::broken, {.name = "Broken",
                                  .start_bit = 62,
                                  .bits = 1,
                                  .comment = "a tendon has broken, until its new epoch"}),
      field(&LifeStatus::slack,
            {.name = "Slack", .start_bit = 63, .bits = 1, .comment = "a tendon hangs loose"}),
  };
};

template <>
struct Layout<Emergency> {
  static constexpr const Frame& kFrame = kEmergencyFrame;
  static constexpr std::string_view kName = kFrame.name;
  static constexpr std::string_view kComment = {};
  static constexpr std::tuple kFields{
      field(&Emergency::code, {.name = "EmergencyCode",
                               .start_bit = 0,
                               .bits = 16,
                               .comment = "what happened",
                               .values = kEmergencyCodes}),
      field(&Emergency::error_register, {.name = "ErrorRegister",
                                         .start_bit = 16,
                                         .bits = 8,
                                         .comment = "what lasts (CiA 301, 7.5.2.2)"}),
      field(&Emergency::damage_ppm, {.name = "EmergencyDamage",
                                     .start_bit = 40,
                                     .bits = 24,
                                     .factor = "0.000001",
                                     .comment = "of the worst tendon, 1 is its characteristic "
                                                "life, stops at the end of its range",
                                     .stops = true}),
  };
};

template <>
struct Layout<Command> {
  static constexpr const Frame& kFrame = kCommandFrame;
  static constexpr std::string_view kName = kFrame.name;
  static constexpr std::string_view kComment = {};
  static constexpr std::tuple kFields{
      field(&Command::code, {.name = "CommandCode",
                             .start_bit = 12,
                             .bits = 4,
                             .comment = "what is asked for",
                             .values = kCommandCodes}),
      field(&Command::argument, {.name = "Argument",
                                 .start_bit = 16,
                                 .bits = 8,
                                 .comment = "seconds, page or number of pages"}),
  };
};

}  // namespace protocol::schema
