#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lifemodel/bulk/damage_sum.hpp"
#include "lifemodel/bulk/instructions.hpp"
#include "lifemodel/counting/stretch.hpp"
#include "lifemodel/damage/cycle_law.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::bulk {

/// Counts what closes within a stretch of samples, without knowing what the tendon has seen before.
///
/// Between points a, b, c, d the range b-c closes where it is no larger than a-b and c-d: as a full
/// cycle where it is at least the hysteresis, else the filter does not see it. Taking it out
/// changes nothing else, so the order does not matter. What is left of a stretch are ranges that
/// grow and then shrink, a few dozen points.
///
/// A cycle is counted for good once the turning point that closes it is confirmed. So what closes
/// has to lie before the last turning point that the stretch itself confirms.
class Reducer {
 public:
  /// The most samples of a stretch.
  static constexpr std::size_t kMostSamples = 16384;

  explicit Reducer(const Instructions& instructions)
      : instructions_(&instructions),
        extrema_(kMostSamples + kSpare),
        passed_{std::vector<std::int32_t>(kMostSamples + kSpare),
                std::vector<std::int32_t>(kMostSamples + kSpare)},
        stack_(kBelowStack + kMostSamples + kSpare),
        from_(kMostSamples / 2 + 2 * kSpare),
        to_(kMostSamples / 2 + 2 * kSpare) {
    left_.reserve(kMostSamples);
  }

  /// Nothing where the samples reach the ultimate tension or lie below zero by more than the
  /// hysteresis: such turning points are counted one by one. What is left is valid until the next
  /// call.
  /// @param law of a cycle, which way round does not matter
  /// @pre 1 .. kMostSamples samples, hysteresis >= one step
  template <class Law>
  std::optional<Stretch> reduce(std::span<const Tension> samples, TensionRange hysteresis,
                                const Law& law) {
    static_assert(sizeof(Tension) == sizeof(std::int32_t));
    if (hysteresis.raw() > static_cast<std::uint32_t>(kUltimate.raw())) {
      return std::nullopt;  // so that ranges have a sign bit to spare
    }
    const auto least = static_cast<std::int32_t>(hysteresis.raw());
    Extremes extremes{};
    const std::size_t count =
        instructions_->find_extrema(reinterpret_cast<const std::int32_t*>(samples.data()),
                                    samples.size(), extrema_.data(), extremes);
    if (extremes.lowest < -least || extremes.highest >= kUltimate.raw()) {
      return std::nullopt;
    }
    cycles_ = {from_.data(), to_.data(), 0};
    std::int32_t* const bottom = stack_.data() + kBelowStack;
    deepest_ = bottom;
    const std::size_t last = last_turning_point(count, least);
    std::size_t nested = 0;
    std::int32_t* end = bottom;
    if (last != 0) {
      nested = close(extrema_.data(), last + 1, least, end);
      --end;
    }
    close(extrema_.data() + last, count - last, least, end);

    left_.clear();
    for (const std::int32_t* point = bottom; point != end; ++point) {
      left_.push_back(Tension::from_raw(*point));
    }
    Stretch stretch;
    stretch.left = left_;
    stretch.cycles = cycles_.count;
    stretch.damage = damage(law);
    stretch.nesting =
        static_cast<std::uint32_t>(nested + static_cast<std::size_t>(deepest_ - bottom));
    return stretch;
  }

 private:
  /// Places below the stack that may be read.
  static constexpr std::size_t kBelowStack = 3;

  /// Which of the first `count` extrema is the last that a filter confirms, whatever it has seen
  /// before: the signal comes to it and leaves it over at least the hysteresis. 0 where none is.
  [[nodiscard]] std::size_t last_turning_point(std::size_t count, std::int32_t hysteresis) const {
    std::size_t i = count - 1;
    std::int32_t lowest = extrema_[i];
    std::int32_t highest = extrema_[i];
    while (highest - lowest < hysteresis) {
      if (i == 0) {
        return 0;
      }
      --i;
      lowest = std::min(lowest, extrema_[i]);
      highest = std::max(highest, extrema_[i]);
    }
    const bool is_high = extrema_[i] == highest;
    std::size_t furthest = i;
    while (i != 0) {
      --i;
      const std::int32_t beyond =
          is_high ? extrema_[i] - extrema_[furthest] : extrema_[furthest] - extrema_[i];
      if (beyond > 0) {
        furthest = i;
      } else if (-beyond >= hysteresis) {
        return furthest;
      }
    }
    return 0;
  }

  /// Takes out what closes among the points and puts the rest from `end` of the stack on. Returns
  /// how many of what is taken out may be open at once beside what is on the stack.
  std::size_t close(const std::int32_t* points, std::size_t count, std::int32_t hysteresis,
                    std::int32_t*& end) {
    // A pass takes out two thirds of points that are independent, and none where ranges are alike.
    constexpr std::size_t kWorthAPass = 64;
    std::size_t passes = 0;
    for (std::size_t before = 2 * count; count > kWorthAPass && count < before - before / 4;) {
      std::vector<std::int32_t>& to = passed_[passes % 2];
      before = count;
      count = instructions_->take_out_ranges(points, count, to.data(), hysteresis, cycles_);
      points = to.data();
      ++passes;
    }
    const std::int32_t* const bottom = end;
    std::int32_t* top = end;
    std::int32_t* from = cycles_.from + cycles_.count;
    std::int32_t* to = cycles_.to + cycles_.count;
    for (const std::int32_t* const last = points + count; points != last;) {
      // Whether a range closes cannot be predicted, so both outcomes are written.
      const std::int32_t a = top[-3];
      const std::int32_t b = top[-2];
      const std::int32_t c = top[-1];
      const std::int32_t range = OneLane::distance(b, c);
      const unsigned smaller_before = OneLane::less(OneLane::distance(a, b), range);
      const unsigned smaller_after = OneLane::less(OneLane::distance(c, *points), range);
      const unsigned closes =
          (top - bottom >= 3 ? 1u : 0u) & (1u ^ smaller_before) & (1u ^ smaller_after);
      *from = b;
      *to = c;
      const unsigned counted = closes & (1u ^ OneLane::less(range, hysteresis));
      from += counted;
      to += counted;
      *top = *points;
      top = closes != 0 ? top - 2 : top + 1;
      points += 1u ^ closes;
      deepest_ = std::max(deepest_, top);
    }
    cycles_.count = static_cast<std::size_t>(from - cycles_.from);
    end = top;
    return 2 * passes;
  }

  Damage damage(const CycleLaw& law) const {
    DamageSum sum;
    instructions_->add_damages(cycles_, law, sum);
    return sum.total();
  }
  template <class Law>
  Damage damage(const Law& law) const {
    if (const CycleLaw* nominal = law.nominal_alone()) {
      return damage(*nominal);
    }
    DamageSum sum;
    for (std::size_t i = 0; i < cycles_.count; ++i) {
      sum.add(static_cast<unsigned>(i), law.below_ultimate(Tension::from_raw(cycles_.from[i]),
                                                           Tension::from_raw(cycles_.to[i])));
    }
    return sum.total();
  }

  const Instructions* instructions_;
  std::vector<std::int32_t> extrema_;
  std::vector<std::int32_t> passed_[2];
  std::vector<std::int32_t> stack_;
  std::int32_t* deepest_ = nullptr;
  std::vector<std::int32_t> from_;
  std::vector<std::int32_t> to_;
  CycleList cycles_{};
  std::vector<Tension> left_;
};

}  // namespace lifemodel::bulk
