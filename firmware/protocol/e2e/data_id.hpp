#pragma once

#include <cstdint>

#include "firmware/protocol/messages.hpp"

namespace protocol::e2e {

inline constexpr std::uint8_t kCounters = 16;  ///< 0 .. 15

/// The lists of 16 data ids of Profile 22, one for each protected frame and node.
///
/// Frame list `l`, 0 .. 3, and node `n` together are the number k = 128 l + n, and with products of
/// polynomials over GF(2)
///   id[counter] = (k mod 256) xor (counter x m),  m = 0x06 where l < 2, else 0x0c.
/// Lists of one m have no id at the same counter; lists of different m have at most one, because
/// counter x (0x06 xor 0x0c) takes no value twice. There are more lists than the 256 that could
/// differ everywhere, so nothing does better: a frame taken for another passes at one counter of 16
/// at most, and never twice running.
///
/// An error in the counter also changes the id that is expected, and most m let some errors of 3
/// bits cancel so. With 0x06 and 0x0c, and the header at byte 0 or at byte 3, none does.
class DataIds {
 public:
  constexpr DataIds(std::uint8_t list, Node node)
      : base_(static_cast<std::uint8_t>((list << 7) | (node & 0x7f))),
        shift_(static_cast<std::uint8_t>(1 + (list >> 1))) {}

  [[nodiscard]] constexpr std::uint8_t at(std::uint8_t counter) const {
    return static_cast<std::uint8_t>(base_ ^ ((counter ^ (counter << 1)) << shift_));
  }

 private:
  std::uint8_t base_;
  std::uint8_t shift_;
};

}  // namespace protocol::e2e
