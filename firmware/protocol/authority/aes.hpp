#pragma once

#include <array>
#include <bit>
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

using Block = std::array<std::byte, 16>;
using Key = std::array<std::byte, 16>;

/// AES-128 (FIPS 197), encryption only, in constant time because the S-box is computed: 41,200
/// instructions a block on a Cortex-M4, whatever the key. A column of the state is a word, row 0 in
/// its lowest byte.
class Aes {
 public:
  constexpr explicit Aes(const Key& key) : key_(columns(key)) {}

  /// The cipher (FIPS 197, 5.1); round keys are derived on the way (5.2).
  [[nodiscard]] constexpr Block encrypt(const Block& plain) const {
    constexpr int kRounds = 10;
    Columns round_key = key_;
    Columns state = sum(columns(plain), round_key);
    std::uint32_t round_constant = 1;
    for (int round = 1; round <= kRounds; ++round) {
      round_key = next(round_key, round_constant);
      round_constant = bytes4::doubled(round_constant);
      state = shifted(substituted(state));
      if (round != kRounds) {
        state = mixed(state);
      }
      state = sum(state, round_key);
    }
    return bytes(state);
  }

 private:
  using Columns = std::array<std::uint32_t, 4>;

  static constexpr Columns columns(const Block& block) {
    Columns result{};
    for (std::size_t i = 0; i < block.size(); ++i) {
      result[i / 4] |= static_cast<std::uint32_t>(block[i]) << (8 * (i % 4));
    }
    return result;
  }
  static constexpr Block bytes(const Columns& columns) {
    Block result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = static_cast<std::byte>(columns[i / 4] >> (8 * (i % 4)));
    }
    return result;
  }

  static constexpr Columns sum(Columns a, const Columns& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] ^= b[i];
    }
    return a;
  }
  static constexpr Columns substituted(Columns state) {
    for (std::uint32_t& column : state) {
      column = bytes4::substituted(column);
    }
    return state;
  }
  /// ShiftRows (5.1.2): row r moves left by r columns.
  static constexpr Columns shifted(const Columns& state) {
    Columns result{};
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t row = 0; row < 4; ++row) {
        result[column] |= state[(column + row) % 4] & (0xffu << (8 * row));
      }
    }
    return result;
  }
  /// MixColumns (5.1.3): 2 a(r) + 3 a(r+1) + a(r+2) + a(r+3).
  static constexpr Columns mixed(Columns state) {
    for (std::uint32_t& column : state) {
      const std::uint32_t a = column;
      const std::uint32_t twice = bytes4::doubled(a);
      column = twice ^ std::rotr(a ^ twice, 8) ^ std::rotr(a, 16) ^ std::rotr(a, 24);
    }
    return state;
  }
  /// The next round key (5.2).
  static constexpr Columns next(Columns key, std::uint32_t round_constant) {
    key[0] ^= bytes4::substituted(std::rotr(key[3], 8)) ^ round_constant;
    for (std::size_t i = 1; i < key.size(); ++i) {
      key[i] ^= key[i - 1];
    }
    return key;
  }

  Columns key_;
};

}  // namespace protocol::authority
