#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lifemodel/state/flags.hpp"

namespace lifemodel {

/// Damage of one counted cycle: mantissa * 2^(position - Damage::kFractionBits).
/// mantissa is in Q31, 2^31 .. 2^32 - 1; position is -2^10 .. Damage::kFractionBits - 31.
struct CycleDamage {
  std::uint32_t mantissa;
  std::int32_t position;

  [[nodiscard]] constexpr CycleDamage half() const { return {mantissa, position - 1}; }
};

/// Miner damage, Q24.104 in 128 bits: 0 .. 2^24, resolution 5e-32. Sums are exact, so their order
/// does not matter. Overflow saturates and raises Flag::saturated.
class Damage {
 public:
  static constexpr int kFractionBits = 104;
  using Words = std::array<std::uint32_t, 4>;  ///< least significant first

  constexpr Damage() = default;
  static constexpr Damage from_words(const Words& words) { return Damage(words); }
  [[nodiscard]] constexpr const Words& words() const { return words_; }

  /// Adds a cycle. What lies below the resolution is rounded down, but a cycle adds at least one
  /// step: the smallest cycle is never lost.
  constexpr void add(CycleDamage cycle, Flags& flags) {
    std::uint32_t mantissa = cycle.mantissa;
    std::uint32_t position = 0;
    if (cycle.position >= 0) {
      position = static_cast<std::uint32_t>(cycle.position);
    } else {
      mantissa = cycle.position > -32 ? mantissa >> -cycle.position : 0;
      mantissa += mantissa == 0 ? 1u : 0u;
    }
    std::size_t word = position / 32;
    const std::uint64_t shifted = std::uint64_t{mantissa} << (position % 32);
    std::uint64_t sum = std::uint64_t{words_[word]} + static_cast<std::uint32_t>(shifted);
    words_[word] = static_cast<std::uint32_t>(sum);
    sum = (sum >> 32) + (shifted >> 32);
    while (sum != 0) {
      if (++word == words_.size()) {
        saturate(flags);
        return;
      }
      sum += words_[word];
      words_[word] = static_cast<std::uint32_t>(sum);
      sum >>= 32;
    }
  }

  constexpr void add(const Damage& other, Flags& flags) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      carry += std::uint64_t{words_[i]} + other.words_[i];
      words_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    if (carry != 0) {
      saturate(flags);
    }
  }

  /// In steps of 1e-9, rounded down; stops at 2^32 - 1.
  [[nodiscard]] constexpr std::uint32_t parts_per_billion() const {
    constexpr std::uint32_t kBillion = 1'000'000'000;
    // Whole lives are in the bits from 104 on, so the fraction fills words 0 .. 2 and 8 bits of
    // word 3.
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i + 1 < words_.size(); ++i) {
      carry = std::uint64_t{words_[i]} * kBillion + (carry >> 32);
    }
    const std::uint64_t scaled = std::uint64_t{words_[3]} * kBillion + (carry >> 32);
    constexpr int kDrop = kFractionBits - 96;
    const std::uint64_t result = scaled >> kDrop;
    constexpr std::uint32_t kHighest = std::numeric_limits<std::uint32_t>::max();
    return result < kHighest ? static_cast<std::uint32_t>(result) : kHighest;
  }

  friend constexpr bool operator==(const Damage&, const Damage&) = default;
  friend constexpr std::strong_ordering operator<=>(const Damage& a, const Damage& b) {
    for (std::size_t i = a.words_.size(); i-- > 0;) {
      if (a.words_[i] != b.words_[i]) {
        return a.words_[i] <=> b.words_[i];
      }
    }
    return std::strong_ordering::equal;
  }

 private:
  constexpr explicit Damage(const Words& words) : words_(words) {}
  constexpr void saturate(Flags& flags) {
    words_.fill(std::numeric_limits<std::uint32_t>::max());
    flags.raise(Flag::saturated);
  }

  Words words_{};
};

/// The largest damage of a cycle: one whole life.
inline constexpr CycleDamage kWholeLife{1u << 31, Damage::kFractionBits - 31};

}  // namespace lifemodel
