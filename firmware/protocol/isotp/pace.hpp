#pragma once

#include <cstdint>

#include "hal/clock.hpp"

namespace protocol::isotp {

/// What a receiver asks of its sender.
///
/// One flow control for a whole message: each of them is a frame of ours. 5 ms between frames hold
/// a sender to 32 kbit/s and suit a receiver that looks once in that time.
struct Pace {
  std::uint8_t block_size = 0;  ///< consecutive frames for each flow control; 0: all
  std::uint8_t st_min = 5;      ///< see separation()
};

/// Limits of ISO 15765-2, 9.8.
inline constexpr hal::Time kFlowControlTimeout = hal::milliseconds(1000);  ///< N_Bs
inline constexpr hal::Time kConsecutiveTimeout = hal::milliseconds(1000);  ///< N_Cr
inline constexpr std::uint8_t kMostWaits = 10;  ///< flow controls in a row that say wait

/// The longest that a frame of 8 bytes takes: 160 bits at 500 kbit/s. A gap counts from the end of
/// a frame, and the sender only knows when it handed the frame over.
inline constexpr hal::Time kFrameTime = hal::microseconds(320);

}  // namespace protocol::isotp
