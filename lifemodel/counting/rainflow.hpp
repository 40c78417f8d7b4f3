#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// A full cycle that has been counted. Trivial, so that a buffer of them costs nothing.
class FullCycle {
 public:
  FullCycle() = default;
  constexpr FullCycle(Tension from, Tension to) : from_(from.raw()), to_(to.raw()) {}
  [[nodiscard]] constexpr Tension from() const { return Tension::from_raw(from_); }
  [[nodiscard]] constexpr Tension to() const { return Tension::from_raw(to_); }

 private:
  std::int32_t from_;
  std::int32_t to_;
};

/// Streaming rainflow counting on exact turning points, in bounded steps.
///
/// Counts as the four-point method with the residue as half cycles, which as a multiset is ASTM
/// E1049-85 5.4.4. The ranges of the points kept here never grow from one to the next: a first
/// range that is smaller than the second can never be closed any more, whatever follows, so its
/// half cycle is final and its point is not kept. What is kept is bounded: k tension levels nest at
/// most 2k - 1 deep.
///
/// When all places are taken, the smallest two ranges a-b, b-c at the end give way: a-b, the larger
/// of the two, is counted as a full cycle, and b and c are forgotten. The count is then larger than
/// the exact one, never smaller.
template <std::size_t kCapacity>
class Residue {
  static_assert(kCapacity >= 4);

 public:
  /// What take() has done.
  struct Progress {
    std::uint32_t taken;   ///< turning points
    std::uint32_t closed;  ///< full cycles, written to the buffer
  };

  /// Takes in the turning points next(first) .. next(last - 1), indices modulo 2^32, until `effort`
  /// is used up: a point takes 1, a full cycle 2, a half cycle that became final 2. `closed` has
  /// room for (effort + 1) / 2 cycles; `sink.half(from, to)` hears of the half cycles,
  /// `sink.overflow()` of a full residue.
  template <class Next, class Sink>
  [[gnu::always_inline]] constexpr Progress take(Next next, std::uint32_t first, std::uint32_t last,
                                                 std::int32_t effort, FullCycle* closed,
                                                 Sink&& sink) {
    std::uint32_t index = first;
    while (size_ < 2 && index != last) {
      points_[size_++] = next(index++);
    }
    Tension* const low = points_.data() + 2;
    Tension* const high = points_.data() + kCapacity;
    Tension* end = points_.data() + size_;
    FullCycle* out = closed;
    std::int32_t mirror = mirror_at(size_);
    while (effort > 0 && index != last) {
      // Whether a cycle closes cannot be predicted, so both outcomes are written, past the end
      // where they do not hold.
      const Tension point = next(index);
      const Tension b = end[-2];
      const Tension c = end[-1];
      const bool closes = (point.raw() ^ mirror) >= (b.raw() ^ mirror);
      *out = {b, c};
      *end = point;
      end = closes ? end - 2 : end + 1;
      out = closes ? out + 1 : out;
      mirror = closes ? mirror : ~mirror;
      index = closes ? index : index + 1;
      effort -= closes ? 2 : 1;
      if (end < low || end > high) [[unlikely]] {
        --effort;
        const auto size = static_cast<std::size_t>(end - points_.data());
        out -= size == 0 ? 1 : 0;
        const Edge edge = end > high ? overflow(*out, sink) : refill(size, point, sink);
        out += edge.closed;
        index += edge.taken;
        end = points_.data() + edge.size;
        mirror = mirror_at(edge.size);
      }
    }
    size_ = static_cast<std::size_t>(end - points_.data());
    return {index - first, static_cast<std::uint32_t>(out - closed)};
  }

  /// Reports what would be open if `candidate` were the last turning point, without taking it in:
  /// every full cycle that it would close, and every half cycle of what remains. Without points it
  /// comes from no tension.
  template <class Sink>
  constexpr void open(Tension candidate, Sink&& sink) const {
    std::size_t size = size_;
    while (size >= 3 && reaches(size, candidate)) {
      size -= 2;
      sink.full(points_[size], points_[size + 1]);
    }
    for (std::size_t i = 1; i < size; ++i) {
      sink.half(points_[i - 1], points_[i]);
    }
    sink.half(size != 0 ? points_[size - 1] : Tension{}, candidate);
  }

  [[nodiscard]] constexpr std::span<const Tension> points() const {
    return {points_.data(), size_};
  }

  /// Forgets all points; with append() this puts a stored residue back.
  constexpr void clear() { size_ = 0; }
  /// @pre fewer points than kCapacity, and the point is the next of a residue
  constexpr void append(Tension point) { points_[size_++] = point; }

 private:
  /// -1 where the next point comes from above, so that ^ mirror makes it come from below.
  [[nodiscard]] constexpr std::int32_t mirror_at(std::size_t size) const {
    return size >= 2 && points_[size - 1] > points_[size - 2] ? -1 : 0;
  }

  /// Whether the range from the last point to `next` is at least the last range. As directions
  /// alternate, that is where `next` reaches the point before the last.
  [[nodiscard]] constexpr bool reaches(std::size_t size, Tension next) const {
    const std::int32_t mirror = mirror_at(size);
    return (next.raw() ^ mirror) >= (points_[size - 2].raw() ^ mirror);
  }

  /// What is left to note where the residue was too short or too long.
  struct Edge {
    std::uint32_t size;
    std::uint16_t taken;
    std::uint16_t closed;
  };

  /// `point` has closed the range of the last two points where only `size` were left before them.
  template <class Sink>
  [[gnu::noinline]] constexpr Edge refill(std::size_t size, Tension point, Sink& sink) {
    if (size == 1) {  // a full cycle on top of the first point, which the range now starts from
      points_[1] = point;
    } else if (point != points_[0]) {
      sink.half(points_[0], points_[1]);
      points_[0] = points_[1];
      points_[1] = point;
    } else {
      points_[2] = point;
      return {3, 1, 0};
    }
    return {2, 1, 0};
  }

  template <class Sink>
  [[gnu::noinline]] constexpr Edge overflow(FullCycle& closed, Sink& sink) {
    sink.overflow();
    closed = {points_[kCapacity - 2], points_[kCapacity - 1]};
    return {kCapacity - 1, 0, 1};
  }

  std::size_t size_ = 0;
  std::array<Tension, kCapacity + 1> points_{};  ///< one more for the point that overflows
};

}  // namespace lifemodel
