#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

namespace hal {

/// A span of time, or the time since an arbitrary start, in microseconds. Never wraps.
struct Time {
  std::uint64_t us = 0;

  friend constexpr auto operator<=>(Time, Time) = default;
  friend constexpr Time operator+(Time a, Time b) { return {a.us + b.us}; }
  /// @pre b <= a
  friend constexpr Time operator-(Time a, Time b) { return {a.us - b.us}; }
};

constexpr Time microseconds(std::uint64_t n) {
  return {n};
}
constexpr Time milliseconds(std::uint64_t n) {
  return {n * 1'000};
}
constexpr Time seconds(std::uint64_t n) {
  return {n * 1'000'000};
}

/// Gives the time, which never runs back.
template <class T>
concept Clock = requires(const T& clock) {
  { clock.now() } -> std::same_as<Time>;
};

}  // namespace hal
