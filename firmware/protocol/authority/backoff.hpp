#pragma once

#include <cstdint>

#include "hal/clock.hpp"

namespace protocol::authority {

inline constexpr std::uint32_t kFreeFailures = 3;  ///< failures that lock for the first time
inline constexpr hal::Time kFirstBackoff = hal::seconds(10);
inline constexpr std::uint32_t kMostDoublings = 6;
/// Failures from which on no further one makes the lock longer.
inline constexpr std::uint32_t kMostFailures = kFreeFailures + kMostDoublings;

/// How long nothing is allowed after so many failures since the last success: nothing, 10 s from
/// the third on, twice as long with each one more, at most 640 s.
constexpr hal::Time backoff(std::uint32_t failures) {
  if (failures < kFreeFailures) {
    return {};
  }
  const std::uint32_t counted = failures < kMostFailures ? failures : kMostFailures;
  return {kFirstBackoff.us << (counted - kFreeFailures)};
}

}  // namespace protocol::authority
