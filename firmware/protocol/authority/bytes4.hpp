#pragma once

#include <array>
#include <cstddef>
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

/// A map that is linear over GF(2), by what it makes of each bit.
using LinearMap = std::array<std::uint8_t, 8>;

constexpr std::uint32_t mapped(std::uint32_t a, const LinearMap& map) {
  std::uint32_t sum = 0;
  for (std::size_t bit = 0; bit < map.size(); ++bit) {
    sum ^= ((a >> bit) & kOnes) * map[bit];
  }
  return sum;
}

/// Squaring, so many times.
consteval LinearMap squaring(int times) {
  LinearMap map{};
  for (std::size_t bit = 0; bit < map.size(); ++bit) {
    std::uint32_t value = 1u << bit;
    for (int i = 0; i < times; ++i) {
      value = product(value, value);
    }
    map[bit] = static_cast<std::uint8_t>(value);
  }
  return map;
}

/// Each byte to the power of 254: its inverse, and 0 for 0.
constexpr std::uint32_t inverse(std::uint32_t a) {
  constexpr LinearMap kTo2 = squaring(1);
  constexpr LinearMap kTo4 = squaring(2);
  constexpr LinearMap kTo16 = squaring(4);
  const std::uint32_t to_2 = mapped(a, kTo2);
  const std::uint32_t to_3 = product(to_2, a);
  const std::uint32_t to_12 = mapped(to_3, kTo4);
  const std::uint32_t to_14 = product(to_12, to_2);
  const std::uint32_t to_15 = product(to_12, to_3);
  return product(mapped(to_15, kTo16), to_14);
}

/// SubBytes (FIPS 197, 5.1.1): the inverse, and an affine map.
LIFEMODEL_ONE_COPY constexpr std::uint32_t substituted(std::uint32_t a) {
  constexpr LinearMap kAffine{0x1f, 0x3e, 0x7c, 0xf8, 0xf1, 0xe3, 0xc7, 0x8f};
  return mapped(inverse(a), kAffine) ^ 0x63636363u;
}

}  // namespace bytes4

}  // namespace protocol::authority
