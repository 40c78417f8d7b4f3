#pragma once

#include <cstdint>

namespace protocol::isotp {

/// What a link has seen since its start. Each stops at 2^32 - 1.
struct Counts {
  std::uint32_t received = 0;         ///< whole messages
  std::uint32_t sent = 0;             ///< whole messages, as far as the sender can tell
  std::uint32_t malformed = 0;        ///< frames whose type, length and size contradict each other
  std::uint32_t unexpected = 0;       ///< frames that nothing had asked for
  std::uint32_t oversized = 0;        ///< messages too long for this link
  std::uint32_t not_taken = 0;        ///< messages that came while the last one was still here
  std::uint32_t interrupted = 0;      ///< messages cut off by the next one
  std::uint32_t wrong_sequence = 0;   ///< messages with a consecutive frame missing or twice
  std::uint32_t receive_timeout = 0;  ///< messages whose rest did not come (N_Cr)
  std::uint32_t send_timeout = 0;     ///< messages for which no flow control came (N_Bs)
  std::uint32_t send_refused = 0;  ///< messages that the receiver refused, or made wait too often

  friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

constexpr void count(std::uint32_t& counter) {
  if (counter + 1 != 0) {
    ++counter;
  }
}

}  // namespace protocol::isotp
