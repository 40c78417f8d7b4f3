#pragma once

#include <cstdint>

#include "lifemodel/support/inlining.hpp"

namespace protocol::authority {

/// Four elements of GF(2^8) at a time, one a byte of a word, modulo x^8 + x^4 + x^3 + x + 1
/// (FIPS 197, 4.2). No table, no branch and no address depends on them, so neither does the time.
namespace bytes4 {

inline constexpr std::uint32_t kOnes = 0x01010101;

/// Each byte times x (FIPS 197, 4.2.1: xtime).
constexpr std::uint32_t doubled(std::uint32_t a) {
  return ((a & 0x7f7f7f7fu) << 1) ^ (((a >> 7) & kOnes) * 0x1bu);
}

/// Byte by byte.
constexpr std::uint32_t product(std::uint32_t a, std::uint32_t b) {
  std::uint32_t sum = 0;
  for (int bit = 0; bit < 8; ++bit) {
    sum ^= a & ((b & kOnes) * 0xffu);
    a = doubled(a);
    b >>= 1;
  }
  return sum;
}

/// Each byte to the power of 254: its inverse, and 0 for 0.
constexpr std::uint32_t inverse(std::uint32_t a) {
  const auto squared = [](std::uint32_t value, int times) {
    for (; times > 0; --times) {
      value = product(value, value);
    }
    return value;
  };
  const std::uint32_t to_2 = squared(a, 1);
  const std::uint32_t to_3 = product(to_2, a);
  const std::uint32_t to_12 = squared(to_3, 2);
  const std::uint32_t to_15 = product(to_12, to_3);
  const std::uint32_t to_252 = product(squared(to_15, 4), to_12);
  return product(to_252, to_2);
}

/// Each byte turned left by one bit.
constexpr std::uint32_t turned(std::uint32_t a) {
  return ((a & 0x7f7f7f7fu) << 1) | ((a >> 7) & kOnes);
}

/// SubBytes (FIPS 197, 5.1.1): the inverse, and an affine map.
LIFEMODEL_ONE_COPY constexpr std::uint32_t substituted(std::uint32_t a) {
  std::uint32_t term = inverse(a);
  std::uint32_t sum = term ^ 0x63636363u;
  for (int i = 0; i < 4; ++i) {
    term = turned(term);
    sum ^= term;
  }
  return sum;
}

}  // namespace bytes4

}  // namespace protocol::authority
