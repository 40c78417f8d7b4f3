#pragma once

#include "firmware/protocol/schema/frame.hpp"

/// The frames: the predefined connection set of CANopen (CiA 301, 7.3.3), classic CAN, 11 bits.
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

}  // namespace protocol::schema
