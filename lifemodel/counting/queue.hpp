#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace lifemodel {

/// What push() does with turning points for which the queue has no place because settle() is late.
///
/// A run of such points is replaced, once there is place again, by its extremes; for each two
/// points beyond those, one full cycle from the lowest to the highest of all points ever left out
/// is owed. So the count is at least the exact one. A run of one or two points loses nothing.
///
/// Written by the producer only; the consumer reads owed(), lowest() and highest(), which only
/// widen.
class Overrun {
 public:
  /// Places in the queue that finish() needs, with one for the turning point that follows.
  static constexpr std::uint32_t kPlaces = 4;

  /// Producer: whether a run is under way.
  [[nodiscard]] bool leaving_out() const { return length_.own() != 0; }
  /// Consumer: the same.
  [[nodiscard]] bool running() const { return length_.acquire() != 0; }
  /// The extreme of the current run on the side where it began: what is known to follow the queue.
  [[nodiscard]] Tension first_extreme() const {
    return (began_low_.relaxed() ? run_lowest_ : run_highest_).relaxed();
  }

  void leave_out(Tension turning_point, bool is_low) {
    if (length_.own() == 0) {
      began_low_.set_plain(is_low);
      run_lowest_.set_plain(turning_point);
      run_highest_.set_plain(turning_point);
    }
    run_lowest_.set_plain(std::min(run_lowest_.own(), turning_point));
    run_highest_.set_plain(std::max(run_highest_.own(), turning_point));
    lowest_.set_plain(std::min(lowest_.own(), turning_point));
    highest_.set_plain(std::max(highest_.own(), turning_point));
    length_.release(length_.own() + 1);
  }

  /// Ends the run: puts its extremes.
  template <class Put>
  void finish(Put&& put) {
    const Tension first = first_extreme();
    put(first);
    if (length_.own() > 1) {
      put((began_low_.own() ? run_highest_ : run_lowest_).own());
    }
    if (length_.own() > 2) {
      if (length_.own() % 2 != 0) {
        put(first);
      }
      owed_.release(owed_.own() + length_.own() / 2 - 1);
    }
    length_.release(0);
  }

  [[nodiscard]] std::uint32_t owed() const { return owed_.acquire(); }
  [[nodiscard]] Tension lowest() const { return lowest_.relaxed(); }
  [[nodiscard]] Tension highest() const { return highest_.relaxed(); }

  /// The whole state as plain words, for storage.
  struct State {
    std::uint32_t length;
    std::uint32_t owed;
    std::uint32_t began_low;
    std::int32_t run_lowest, run_highest, lowest, highest;
  };
  [[nodiscard]] State state() const {
    return {length_.own(),
            owed_.own(),
            began_low_.own() ? 1u : 0u,
            run_lowest_.own().raw(),
            run_highest_.own().raw(),
            lowest_.own().raw(),
            highest_.own().raw()};
  }
  /// Whether such a state can arise, where `paid` of the owed cycles have been counted.
  static constexpr bool plausible(const State& s, std::uint32_t paid) {
    const bool in_range = Tension::checked(s.run_lowest) && Tension::checked(s.run_highest) &&
                          Tension::checked(s.lowest) && Tension::checked(s.highest);
    const bool run_fits =
        s.length == 0 || (s.lowest <= s.run_lowest && s.highest >= s.run_highest &&
                          (s.run_lowest < s.run_highest) == (s.length > 1));
    return in_range && run_fits && s.began_low <= 1 && paid <= s.owed &&
           (s.owed == 0 || s.lowest < s.highest);
  }
  /// Whether the points that finish() would put continue those that `alternation` has seen.
  /// @pre plausible, with a run
  template <class Alternation>
  static constexpr bool extend(const State& s, Alternation& alternation) {
    const Tension low = Tension::from_raw(s.run_lowest);
    const Tension high = Tension::from_raw(s.run_highest);
    const bool began_low = s.began_low != 0;
    return alternation.next(began_low ? low : high) &&
           (s.length < 2 || alternation.next(began_low ? high : low)) &&
           (s.length < 3 || s.length % 2 == 0 || alternation.next(began_low ? low : high));
  }
  /// @pre plausible
  void restore(const State& s) {
    length_.set_relaxed(s.length);
    owed_.set_relaxed(s.owed);
    began_low_.set_plain(s.began_low != 0);
    run_lowest_.set_plain(Tension::from_raw(s.run_lowest));
    run_highest_.set_plain(Tension::from_raw(s.run_highest));
    lowest_.set_plain(Tension::from_raw(s.lowest));
    highest_.set_plain(Tension::from_raw(s.highest));
  }

 private:
  SharedWord<std::uint32_t> length_;
  SharedWord<std::uint32_t> owed_;
  SharedWord<bool> began_low_;
  SharedWord<Tension> run_lowest_;
  SharedWord<Tension> run_highest_;
  SharedWord<Tension> lowest_{Tension::highest()};
  SharedWord<Tension> highest_{Tension::lowest()};
};

/// Turning points on their way from push() to settle(): one producer, which may be an interrupt or
/// another core, and one consumer. Neither waits for the other.
template <std::size_t kCapacity>
class TurningPointQueue {
  static_assert(kCapacity >= 8 && (kCapacity & (kCapacity - 1)) == 0, "a power of two");

 public:
  /// Producer: places that are free.
  [[nodiscard]] std::uint32_t free() const {
    return static_cast<std::uint32_t>(kCapacity) - (head_.own() - tail_.acquire());
  }
  /// Producer: appends.
  /// @pre free() > 0
  void put(Tension turning_point) {
    points_[head_.own() % kCapacity] = turning_point;
    head_.release(head_.own() + 1);
  }

  /// Producer: appends many without a branch for each.
  class Batch {
   public:
    explicit Batch(TurningPointQueue& queue) : queue_(queue), head_(queue.head_.own()) {}
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;
    ~Batch() { queue_.head_.release(head_); }
    /// Appends where `wanted`.
    /// @pre a place is free, wanted or not
    void put_if(bool wanted, Tension turning_point) {
      queue_.points_[head_ % kCapacity] = turning_point;
      head_ += wanted ? 1 : 0;
    }

   private:
    TurningPointQueue& queue_;
    std::uint32_t head_;
  };

  /// Consumer: turning points that wait.
  [[nodiscard]] std::uint32_t size() const { return head_.acquire() - tail_.own(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// Consumer.
  /// @pre index < size()
  [[nodiscard]] Tension at(std::uint32_t index) const {
    return points_[(tail_.own() + index) % kCapacity];
  }
  /// Consumer.
  /// @pre count <= size()
  void drop(std::uint32_t count) { tail_.release(tail_.own() + count); }

  /// Consumer: what waits as indices first .. last - 1, modulo 2^32.
  struct Range {
    const Tension* points;
    std::uint32_t first;
    std::uint32_t last;
    Tension operator()(std::uint32_t index) const { return points[index % kCapacity]; }
  };
  [[nodiscard]] Range range() const { return {points_.data(), tail_.own(), head_.acquire()}; }

 private:
  SharedWord<std::uint32_t> head_;
  SharedWord<std::uint32_t> tail_;
  std::array<Tension, kCapacity> points_{};
};

}  // namespace lifemodel
