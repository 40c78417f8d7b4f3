#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// Streaming rainflow counting on exact turning points, one bounded step at a time.
///
/// Counts as the four-point method with the residue as half cycles, which as a multiset is ASTM
/// E1049-85 5.4.4. The ranges of the points kept here never grow from one to the next: a first
/// range that is smaller than the second can never be closed any more, whatever follows, so its
/// half cycle is final and its point is not kept. What is kept is bounded: k tension levels nest at
/// most 2k - 1 deep.
///
/// When all places are taken, the smallest two ranges a-b, b-c at the end give way: b-c, the larger
/// of what goes, is counted as a full cycle, and b and c are forgotten. The count is then larger
/// than the exact one, never smaller.
template <std::size_t kCapacity>
class Residue {
  static_assert(kCapacity >= 4);

 public:
  enum class Step : std::uint8_t {
    keep,      ///< the next turning point lies within: it only has to be kept
    close,     ///< it closes the last range as a full cycle
    retire,    ///< it makes the half cycle at the start final
    overflow,  ///< it lies within, but there is no place for it
  };

  /// What the turning point `next` does to the first `size` points.
  [[nodiscard]] constexpr Step classify(std::size_t size, Tension next) const {
    if (size >= 2) {
      const TensionRange coming = distance(points_[size - 1], next);
      const TensionRange last = distance(points_[size - 2], points_[size - 1]);
      if (coming >= last) {
        if (size >= 3) {
          return Step::close;
        }
        if (coming > last) {
          return Step::retire;
        }
      } else if (size == kCapacity) {
        return Step::overflow;
      }
    }
    return Step::keep;
  }

  /// One step of taking in the turning point `next`: at most one cycle is reported to `sink`, as
  /// sink.full(from, to) or sink.half(from, to), and sink.overflow() where the residue was full.
  /// Returns true when `next` has been taken in, false when it needs another step.
  template <class Sink>
  constexpr bool step(Tension next, Sink&& sink) {
    switch (classify(size_, next)) {
      case Step::close:
        size_ -= 2;
        sink.full(points_[size_], points_[size_ + 1]);
        return false;
      case Step::retire:
        sink.half(points_[0], points_[1]);
        points_[0] = points_[1];
        points_[1] = next;
        return true;
      case Step::overflow:
        sink.overflow();
        sink.full(points_[size_ - 2], points_[size_ - 1]);
        --size_;
        return true;
      case Step::keep:
        points_[size_++] = next;
        return true;
    }
    return true;
  }

  /// Reports what would be open if `candidate` were the last turning point, without taking it in:
  /// every full cycle that it would close, and every half cycle of what remains.
  template <class Sink>
  constexpr void open(Tension candidate, Sink&& sink) const {
    std::size_t size = size_;
    Step next = classify(size, candidate);
    while (next == Step::close) {
      size -= 2;
      sink.full(points_[size], points_[size + 1]);
      next = classify(size, candidate);
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
  std::size_t size_ = 0;
  std::array<Tension, kCapacity> points_{};
};

}  // namespace lifemodel
