#pragma once

#include <cstdint>

#include "firmware/protocol/messages.hpp"
#include "hal/can_port.hpp"

namespace app {

/// How the node is, apart from the lives.
struct Conditions {
  std::uint32_t configuration = 0;  ///< CRC-32 over the configurations of all tendons
  bool trusted = false;             ///< no record of the past was lost
  bool sensor_ok = false;
  bool storage_ok = false;
  bool locked = false;                  ///< the drive is held off
  std::uint32_t sequence = 0;           ///< of the last save
  std::uint32_t unsaved_ppb = 0;        ///< rounded up, as are all that follow
  std::uint32_t worst_unsaved_ppb = 0;  ///< since the start
  protocol::detail::Timing timing;
  hal::CanStatus bus;
  std::uint8_t dropped = 0;   ///< detail pages
  std::uint16_t refused = 0;  ///< frames and commands
};

}  // namespace app
