#pragma once

#include <cstdint>

namespace lifemodel::numeric {

/// One of 16 cubic segments c0 + t*(c1 + t*(c2 + t*c3)), 0 <= t < 1. Coefficients in Q31, c1, c2
/// and c3 scaled by 2, 4 and 8 because a product of Q31 numbers keeps only its upper word.
struct Segment {
  std::uint32_t c0;
  std::int32_t c1;
  std::int32_t c2;
  std::int32_t c3;
};

inline constexpr int kSegmentBits = 4;

constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> 32);
}

/// The segment at `t` in Q31, result in Q31.
constexpr std::uint32_t evaluate(const Segment& s, std::int32_t t) {
  const std::int32_t slope = s.c1 + multiply_high(t, s.c2 + multiply_high(t, s.c3));
  return s.c0 + static_cast<std::uint32_t>(multiply_high(t, slope));
}

}  // namespace lifemodel::numeric
