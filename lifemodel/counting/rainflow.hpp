#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// A full cycle that has been counted: its two turning points.
struct FullCycle {
  Tension from;
  Tension to;
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
  /// What take() has done: at most as many as the steps it was given.
  struct Progress {
    std::uint32_t taken;   ///< turning points
    std::uint32_t closed;  ///< full cycles, written to the buffer
  };

  /// Takes turning points in, at most `steps` steps; a step takes one point or closes one cycle.
  /// `next(i)` gives the i-th of `count` points; `closed` has room for `steps` cycles;
  /// `sink.half(from, to)` hears of half cycles that became final, `sink.overflow()` of a full
  /// residue.
  template <class Next, class Sink>
  constexpr Progress take(Next&& next, std::uint32_t count, std::uint32_t steps, FullCycle* closed,
                          Sink&& sink) {
    Progress done{0, 0};
    std::size_t size = size_;
    while (steps != 0 && done.taken != count) {
      --steps;
      const Tension point = next(done.taken);
      if (size < 3 || size == kCapacity) [[unlikely]] {
        size = take_at_end(size, point, closed, done, sink);
        continue;
      }
      // Without a branch: whether a cycle closes cannot be predicted. The point is written past the
      // end where it stays pending.
      const std::uint32_t closes = reaches(size, point) ? 1 : 0;
      closed[done.closed] = {points_[size - 2], points_[size - 1]};
      points_[size] = point;
      done.closed += closes;
      done.taken += 1 - closes;
      size += 1 - 3 * std::size_t{closes};
    }
    size_ = size;
    return done;
  }

  /// Reports what would be open if `candidate` were the last turning point, without taking it in:
  /// every full cycle that it would close, and every half cycle of what remains.
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
    if (size != 0) {
      sink.half(points_[size - 1], candidate);
    }
  }

  [[nodiscard]] constexpr std::span<const Tension> points() const {
    return {points_.data(), size_};
  }
  static constexpr std::size_t capacity() { return kCapacity; }

  /// Forgets all points; with append() this puts a stored residue back.
  constexpr void clear() { size_ = 0; }
  /// Precondition: fewer points than capacity(), and the point is the next of a residue.
  constexpr void append(Tension point) { points_[size_++] = point; }

 private:
  /// Whether the range from the last point to `next` is at least the last range. As directions
  /// alternate, that is where `next` reaches the point before the last.
  [[nodiscard]] constexpr bool reaches(std::size_t size, Tension next) const {
    const Tension before = points_[size - 2];
    return points_[size - 1] > before ? next <= before : next >= before;
  }

  template <class Sink>
  constexpr std::size_t take_at_end(std::size_t size, Tension point, FullCycle* closed,
                                    Progress& done, Sink& sink) {
    if (size >= 3 && reaches(size, point)) {
      closed[done.closed++] = {points_[size - 2], points_[size - 1]};
      return size - 2;
    }
    ++done.taken;
    if (size == kCapacity) {
      sink.overflow();
      closed[done.closed++] = {points_[size - 2], points_[size - 1]};
      return size - 1;
    }
    if (size == 2 && reaches(size, point) && point != points_[0]) {
      sink.half(points_[0], points_[1]);
      points_[0] = points_[1];
      points_[1] = point;
      return size;
    }
    points_[size] = point;
    return size + 1;
  }

  std::size_t size_ = 0;
  std::array<Tension, kCapacity> points_{};
};

}  // namespace lifemodel
