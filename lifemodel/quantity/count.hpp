#pragma once

#include <concepts>
#include <limits>

#include "lifemodel/state/flags.hpp"

namespace lifemodel {

/// A count of events of kind `WhatT`. Stops at its highest value and raises Flag::saturated.
template <class WhatT, std::unsigned_integral RepT>
class Count {
 public:
  using Rep = RepT;

  constexpr Count() = default;
  static constexpr Count from_raw(Rep raw) { return Count(raw); }
  [[nodiscard]] constexpr Rep raw() const { return raw_; }

  constexpr void add(Rep n, Flags& flags) {
    if (__builtin_add_overflow(raw_, n, &raw_)) [[unlikely]] {
      raw_ = std::numeric_limits<Rep>::max();
      flags.raise(Flag::saturated);
    }
  }

  friend constexpr auto operator<=>(Count, Count) = default;

 private:
  constexpr explicit Count(Rep raw) : raw_(raw) {}
  Rep raw_ = 0;
};

struct Cycle {};
struct HalfCycle {};
struct MissingSample {};
struct Event {};

using Cycles = Count<Cycle, std::uint64_t>;
using HalfCycles = Count<HalfCycle, std::uint64_t>;
using MissingSamples = Count<MissingSample, std::uint32_t>;
using Events = Count<Event, std::uint32_t>;

}  // namespace lifemodel
