#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/can_frame.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// What distinguishes frames of CAN FD from those of classic CAN.
enum class PacketKind : std::uint8_t { classic, flexible, as_flag_says };

/// A frame as struct can_frame and struct canfd_frame hold it, without a time (linux/can.h): 4
/// bytes of id and flags, 1 of length, 1 of CAN FD flags, 2 reserved, then the data. Nothing where
/// the bytes are too few, or the length is none. `big_endian`: the order of the bytes of the id, as
/// in a capture (LINKTYPE_CAN_SOCKETCAN); else that of this machine.
std::optional<SeenFrame> frame_of_packet(std::span<const std::byte> packet, bool big_endian,
                                         PacketKind kind);

/// What an error frame reports (linux/can/error.h): its id without the flag is the class, its data
/// hold more.
BusError bus_error_of(const hal::CanFrame& frame);

}  // namespace host_sim::monitor
