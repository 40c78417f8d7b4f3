#pragma once

#include <cstdint>
#include <initializer_list>

namespace lifemodel::numeric {

/// An angle in 2^-32 turns, which wraps as angles do.
using Phase = std::uint32_t;

inline constexpr Phase kQuarterTurn = 1u << 30;

/// Largest error of sine() and cosine().
inline constexpr double kSineMaxError = 1.0e-7;

/// The sine in Q30, by its power series up to the 11th power in a quarter turn.
constexpr std::int32_t sine(Phase phase) {
  // x in Q30 of a quarter turn: -1 .. 1, folded where the sine falls.
  const bool falls = phase - kQuarterTurn < 2 * kQuarterTurn;
  const auto x = static_cast<std::int32_t>(falls ? 2 * kQuarterTurn - phase : phase);
  const auto times = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>((std::int64_t{a} * b + (1 << 29)) >> 30);
  };
  const std::int32_t square = times(x, x);
  std::int32_t sum = -3864;
  for (const std::int32_t coefficient : {172272, -5026995, 85569306, -693598668}) {
    sum = coefficient + times(sum, square);
  }
  // The first coefficient, pi/2, has one bit more than Q30 holds together with its sign.
  constexpr std::int64_t kFirst = 1686629713;
  const std::int64_t slope = kFirst + times(sum, square);
  return static_cast<std::int32_t>((slope * x + (1 << 29)) >> 30);
}

/// The cosine in Q30.
constexpr std::int32_t cosine(Phase phase) {
  return sine(phase + kQuarterTurn);
}

}  // namespace lifemodel::numeric
