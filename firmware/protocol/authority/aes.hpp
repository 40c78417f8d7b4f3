#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "firmware/protocol/authority/bytes4.hpp"

namespace protocol::authority {

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
