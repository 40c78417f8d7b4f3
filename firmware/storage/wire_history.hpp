#pragma once

#include <cstdint>

namespace storage {

/// What has happened to a wire besides its cycles, since it was put in. Counts stop at the end of
/// their ranges.
struct WireHistory {
  std::uint32_t peak = 0;      ///< highest tension by its size, relative to the ultimate one, Q29
  std::uint32_t above_50 = 0;  ///< excursions above 50 % of the ultimate tension
  std::uint32_t above_70 = 0;
  std::uint32_t above_90 = 0;
  std::uint32_t below_minimum_s = 0;  ///< time below the minimum tension
  std::uint32_t operated_s = 0;       ///< time in which it was counted
  std::uint32_t slack_events = 0;
  bool broken = false;

  friend constexpr bool operator==(const WireHistory&, const WireHistory&) = default;
};

/// Whether `next` can be of the same wire later: nothing falls, and what broke stays so.
constexpr bool may_follow(const WireHistory& next, const WireHistory& last) {
  return next.peak >= last.peak && next.above_50 >= last.above_50 &&
         next.above_70 >= last.above_70 && next.above_90 >= last.above_90 &&
         next.below_minimum_s >= last.below_minimum_s && next.operated_s >= last.operated_s &&
         next.slack_events >= last.slack_events && (next.broken || !last.broken);
}

}  // namespace storage
