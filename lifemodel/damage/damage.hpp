#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lifemodel/quantity/flags.hpp"
#include "lifemodel/support/inlining.hpp"

namespace lifemodel {

/// Damage of one counted cycle: mantissa * 2^(position - Damage::kFractionBits).
/// mantissa is in Q31, 2^31 .. 2^32 - 1; position is -30 .. Damage::kFractionBits - 31, one less
/// for a half cycle.
struct CycleDamage {
  std::uint32_t mantissa;
  std::int32_t position;

  [[nodiscard]] constexpr CycleDamage half() const { return {mantissa, position - 1}; }

  [[nodiscard]] constexpr std::uint64_t pack() const {
    return (std::uint64_t{static_cast<std::uint32_t>(position)} << 32) | mantissa;
  }
  static constexpr CycleDamage unpack(std::uint64_t packed) {
    return {static_cast<std::uint32_t>(packed), static_cast<std::int32_t>(packed >> 32)};
  }
};

/// Miner damage, Q24.104 in 128 bits: 0 .. 2^24, resolution 5e-32. Sums are exact, so their order
/// does not matter. Overflow saturates and raises Flag::saturated.
class Damage {
 public:
  static constexpr int kFractionBits = 104;
  using Words = std::array<std::uint32_t, 4>;  ///< least significant first

  constexpr Damage() = default;
  static constexpr Damage from_words(const Words& words) { return Damage(words); }
  [[nodiscard]] constexpr bool none() const {
    return (words_[0] | words_[1] | words_[2] | words_[3]) == 0;
  }
  static constexpr Damage highest() {
    Damage result;
    result.words_.fill(std::numeric_limits<std::uint32_t>::max());
    return result;
  }
  [[nodiscard]] constexpr const Words& words() const { return words_; }

  /// Adds the same cycle several times.
  constexpr void add(CycleDamage cycle, std::uint32_t times, Flags& flags) {
    const std::uint64_t product = std::uint64_t{cycle.mantissa} * times;
    if (const auto low = static_cast<std::uint32_t>(product); low != 0) {
      add(low, cycle.position, *this, flags);
    }
    if (const auto high = static_cast<std::uint32_t>(product >> 32); high != 0) {
      add(high, cycle.position + 32, *this, flags);
    }
  }

  /// Adds a cycle. What lies below the resolution is rounded down.
  constexpr void add(CycleDamage cycle, Flags& flags) {
    add(cycle.mantissa, cycle.position, *this, flags);
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

  /// This damage `times` over; stops at highest().
  [[nodiscard]] constexpr Damage multiplied(std::uint32_t times) const {
    Damage result;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      carry += std::uint64_t{words_[i]} * times;
      result.words_[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    return carry == 0 ? result : highest();
  }

  /// What `larger` has more than `smaller`.
  /// @pre smaller <= larger
  static constexpr Damage difference(const Damage& larger, const Damage& smaller) {
    Damage result;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < result.words_.size(); ++i) {
      const std::uint64_t word = std::uint64_t{larger.words_[i]} - smaller.words_[i] - borrow;
      result.words_[i] = static_cast<std::uint32_t>(word);
      borrow = (word >> 32) & 1u;
    }
    return result;
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

  // In the order in which a packed CycleDamage comes back from its law.
  LIFEMODEL_ONE_COPY static constexpr void add(std::uint32_t mantissa, std::int32_t exponent,
                                               Damage& sum, Flags& flags) {
    std::uint32_t position = 0;
    if (exponent >= 0) [[likely]] {
      position = static_cast<std::uint32_t>(exponent);
    } else {
      mantissa >>= -exponent;
    }
    std::uint32_t* word = sum.words_.data() + position / 32;
    const std::uint32_t shift = position % 32;
    std::uint32_t addend = mantissa << shift;
    std::uint32_t carry = (mantissa >> 1) >> (31 - shift);
    for (;;) {
      const std::uint32_t low = *word + addend;
      carry += low < addend ? 1 : 0;
      *word = low;
      if (carry == 0) {
        return;
      }
      if (++word == sum.words_.data() + sum.words_.size()) {
        sum.saturate(flags);
        return;
      }
      addend = carry;
      carry = 0;
    }
  }
  constexpr void saturate(Flags& flags) {
    words_.fill(std::numeric_limits<std::uint32_t>::max());
    flags.raise(Flag::saturated);
  }

  Words words_{};
};

/// The smallest damage of a cycle: two steps, so that a half cycle has one. Small as it is, no
/// cycle is lost, and closing two half cycles into a full one takes nothing away.
inline constexpr CycleDamage kSmallestCycle{1u << 31, -30};

/// The largest damage of a cycle: one whole life.
inline constexpr CycleDamage kWholeLife{1u << 31, Damage::kFractionBits - 31};

}  // namespace lifemodel
