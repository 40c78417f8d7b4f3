#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "hal/can_frame.hpp"
#include "hal/error.hpp"

namespace hal {

/// State of a CAN controller (ISO 11898-1, fault confinement).
enum class CanState : std::uint8_t { active, warning, passive, off };

struct CanStatus {
  CanState state = CanState::active;
  std::uint8_t transmit_errors = 0;  ///< TEC; stops at 255
  std::uint8_t receive_errors = 0;   ///< REC; stops at 255
  std::uint32_t bus_offs = 0;        ///< since the start
  std::uint32_t lost = 0;            ///< received frames that found no room, since the start

  friend constexpr bool operator==(const CanStatus&, const CanStatus&) = default;
};

/// A CAN controller with its queues. Nothing waits.
///
/// send(): none, and the frame is on its way; full, and nothing has happened; off, while the
/// controller is off the bus. Frames of one call order leave in that order.
/// receive(): the oldest frame that passed the filter, of others only; nothing if there is none.
/// recover(): asks a controller that is off to take part again; none where it is not off.
template <class T>
concept CanPort = requires(T& port, const CanFrame& frame) {
  { port.send(frame) } -> std::same_as<Error>;
  { port.receive() } -> std::same_as<std::optional<CanFrame>>;
  { port.status() } -> std::same_as<CanStatus>;
  { port.recover() } -> std::same_as<Error>;
};

}  // namespace hal
