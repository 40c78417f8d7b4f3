#pragma once

#include <string_view>
#include <tuple>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/frames.hpp"
#include "firmware/protocol/schema/layout.hpp"
#include "firmware/protocol/schema/values.hpp"

/// Layouts of the frames without pages.
namespace protocol::schema {

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
