#pragma once

#include <cstdint>

#include "lifemodel/support/shared_word.hpp"

namespace lifemodel {

/// Conditions that the estimator survives and reports. Each is sticky: once raised it stays raised
/// until the state itself is replaced.
enum class Flag : std::uint32_t {
  saturated = 1u << 0,         ///< a quantity met the end of its closed range
  overload = 1u << 1,          ///< the tension reached the ultimate one
  negative_tension = 1u << 2,  ///< the tension lay below zero by more than the hysteresis
  gap = 1u << 3,               ///< samples were missing
  residue_overflow = 1u << 4,  ///< the residue was full; a cycle was counted larger than it was
  overrun = 1u << 5,           ///< settle() was too late; cycles were counted larger than they were
};

/// A set of sticky flags. One side raises them; seen() is for the other, see SharedWord.
class Flags {
 public:
  constexpr Flags() = default;
  static constexpr Flags from_bits(std::uint32_t bits) { return Flags(bits); }

  constexpr void raise(Flag flag) {
    bits_.set_plain(bits_.own() | static_cast<std::uint32_t>(flag));
  }
  [[nodiscard]] constexpr bool has(Flag flag) const {
    return (bits_.own() & static_cast<std::uint32_t>(flag)) != 0;
  }
  [[nodiscard]] constexpr bool none() const { return bits_.own() == 0; }
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_.own(); }

  [[nodiscard]] Flags seen() const { return Flags(bits_.relaxed()); }

  friend constexpr Flags operator|(Flags a, Flags b) { return Flags(a.bits() | b.bits()); }
  friend constexpr bool operator==(Flags a, Flags b) { return a.bits() == b.bits(); }

 private:
  constexpr explicit Flags(std::uint32_t bits) : bits_(bits) {}
  SharedWord<std::uint32_t> bits_;
};

/// All flags that exist; other bits in stored data mean that the data are not ours.
inline constexpr std::uint32_t kAllFlags = (1u << 6) - 1;

}  // namespace lifemodel
