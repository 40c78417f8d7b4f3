#pragma once

#include <cstdint>

#include "firmware/protocol/messages.hpp"

namespace protocol::e2e {

inline constexpr std::uint8_t kCounters = 16;  ///< 0 .. 15

/// The lists of 16 data ids of Profile 22, one for each protected frame and node.
///
/// Frame list `l` and node `n` together are the number k = 128 l + n, and
///   id[counter] = (k mod 256) xor (counter << (k / 256)).
/// Two lists with the same shift have no id at the same counter; two with different shifts have at
/// most one, because c -> (c << i) xor (c << j) takes no value twice (a product of polynomials over
/// GF(2)). There are more lists than the 256 that could differ everywhere, so nothing does better.
/// A frame taken for another therefore passes at one counter of 16 at most, and never twice
/// running.
class DataIds {
 public:
  constexpr DataIds(std::uint8_t list, Node node)
      : base_(static_cast<std::uint8_t>((list << 7) | (node & 0x7f))),
        shift_(static_cast<std::uint8_t>(list >> 1)) {}

  [[nodiscard]] constexpr std::uint8_t at(std::uint8_t counter) const {
    return static_cast<std::uint8_t>(base_ ^ (counter << shift_));
  }

 private:
  std::uint8_t base_;
  std::uint8_t shift_;
};

}  // namespace protocol::e2e
