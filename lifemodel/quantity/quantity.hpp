#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>

#include "lifemodel/state/flags.hpp"

namespace lifemodel {

/// Overflow policy of measured values: the nearest end of the closed range, and Flag::saturated.
struct SaturateFlagged {};
/// Overflow policy of parameters: a value outside the closed range does not exist.
struct Refuse {};

/// A fixed-point number `raw / 2^kFraction` in the unit `UnitT`, within [kLowest, kHighest] raw.
///
/// Quantities of different unit, Q-format, range or policy are different types: nothing converts
/// between them implicitly, and adding or comparing them does not compile.
template <class UnitT, class RepT, int kFraction, RepT kLowest, RepT kHighest, class OverflowT>
class Quantity {
  static_assert(sizeof(RepT) <= sizeof(std::int32_t), "arithmetic is done in 64 bits");
  static_assert(kLowest <= kHighest);

 public:
  using Rep = RepT;
  using Overflow = OverflowT;
  static constexpr int kFractionBits = kFraction;

  constexpr Quantity() = default;

  static constexpr Quantity lowest() { return Quantity(kLowest); }
  static constexpr Quantity highest() { return Quantity(kHighest); }

  /// The value with this raw representation, or nothing outside the closed range.
  static constexpr std::optional<Quantity> checked(std::int64_t raw) {
    if (raw < std::int64_t{kLowest} || raw > std::int64_t{kHighest}) {
      return std::nullopt;
    }
    return Quantity(static_cast<Rep>(raw));
  }

  /// The value nearest to this raw representation; raises Flag::saturated outside the range.
  static constexpr Quantity saturated(
      std::int64_t raw, Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    if (raw < std::int64_t{kLowest}) {
      flags.raise(Flag::saturated);
      return lowest();
    }
    if (raw > std::int64_t{kHighest}) {
      flags.raise(Flag::saturated);
      return highest();
    }
    return Quantity(static_cast<Rep>(raw));
  }

  /// The value with this raw representation. Precondition: within the closed range.
  static constexpr Quantity from_raw(Rep raw) { return Quantity(raw); }

  /// `thousandths` of a unit, to the nearest representable value. For up to 25 fraction bits.
  static constexpr Quantity from_milli(
      std::int32_t thousandths, Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    // 1/1000 as 2^-42 * 4398046511 (error 2.5e-11), so that no 64-bit division is needed.
    constexpr std::uint64_t kThousandth = 4398046511u;
    const bool negative = thousandths < 0;
    const std::uint64_t magnitude = negative
                                        ? 0u - static_cast<std::uint64_t>(std::int64_t{thousandths})
                                        : static_cast<std::uint64_t>(std::int64_t{thousandths});
    const std::uint64_t low = (magnitude & 0xffffu) * kThousandth;
    const std::uint64_t high = (magnitude >> 16) * kThousandth;
    constexpr int kShift = 42 - kFraction;
    static_assert(kShift > 16);
    const std::uint64_t scaled =
        (high + (low >> 16) + (std::uint64_t{1} << (kShift - 17))) >> (kShift - 16);
    const auto raw = static_cast<std::int64_t>(scaled);
    return saturated(negative ? -raw : raw, flags);
  }

  [[nodiscard]] constexpr Rep raw() const { return raw_; }

  /// Sum, saturating.
  static constexpr Quantity sum(Quantity a, Quantity b,
                                Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    return saturated(std::int64_t{a.raw_} + std::int64_t{b.raw_}, flags);
  }
  /// Difference, saturating.
  static constexpr Quantity difference(
      Quantity a, Quantity b, Flags& flags) requires std::same_as<Overflow, SaturateFlagged> {
    return saturated(std::int64_t{a.raw_} - std::int64_t{b.raw_}, flags);
  }

  friend constexpr auto operator<=>(Quantity, Quantity) = default;

 private:
  constexpr explicit Quantity(Rep raw) : raw_(raw) {}
  Rep raw_ = 0;
};

}  // namespace lifemodel
