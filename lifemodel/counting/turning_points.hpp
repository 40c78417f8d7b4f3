#pragma once

#include <cstdint>

#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace lifemodel {

/// Checks that points are turning points: neighbours differ and directions alternate.
class Alternation {
 public:
  constexpr bool next(Tension point) {
    if (count_ != 0) {
      const bool rising = point > last_;
      if (point == last_ || (count_ > 1 && rising == rising_)) {
        return false;
      }
      rising_ = rising;
    }
    last_ = point;
    count_ += count_ < 2 ? 1 : 0;
    return true;
  }
  [[nodiscard]] constexpr bool empty() const { return count_ == 0; }
  /// @pre at least two points
  [[nodiscard]] constexpr bool rising() const { return rising_; }

 private:
  int count_ = 0;
  Tension last_;
  bool rising_ = false;
};

/// Finds turning points with hysteresis, one sample at a time, in constant time.
///
/// A turning point is confirmed once the signal has come back from it by at least the hysteresis.
/// The running extremum is the candidate: the last turning point, not yet confirmed. Before the
/// first direction is known the running maximum and minimum are both kept, and the one that came
/// first becomes the first turning point, so that no range is lost at the start.
class TurningPoints {
 public:
  /// A signal on its way from a turning point. In the mirrored frame it always runs up to the
  /// extremum and turns down.
  struct Run {
    std::int32_t mirror;    ///< 0 while rising, -1 while falling
    std::int32_t extremum;  ///< in the mirrored frame

    [[nodiscard]] constexpr Tension candidate() const {
      return Tension::from_raw((extremum ^ mirror) - mirror);
    }
    /// A sample in the mirrored frame.
    [[nodiscard]] constexpr std::int32_t mirrored(Tension sample) const {
      return (sample.raw() ^ mirror) - mirror;
    }
    /// Takes a sample; true if it confirms the candidate. The run then starts from the sample.
    /// @pre hysteresis >= one step
    constexpr bool turns(Tension sample, TensionRange hysteresis) {
      const std::int32_t value = mirrored(sample);
      const std::int32_t furthest = value > extremum ? value : extremum;
      const bool back = static_cast<std::uint32_t>(furthest) - static_cast<std::uint32_t>(value) >=
                        hysteresis.raw();
      extremum = back ? -value : furthest;
      mirror = back ? ~mirror : mirror;
      return back;
    }
  };

  /// Takes a sample; calls `confirmed(Tension)` at most once.
  /// @pre hysteresis >= one step
  template <class Confirmed>
  void push(Tension sample, TensionRange hysteresis, Confirmed&& confirmed) {
    if (phase_.own() != kDirected) [[unlikely]] {
      if (phase_.own() == kUndirected) {
        seek_direction(sample.raw(), hysteresis, confirmed);
      } else {
        start(sample.raw());
      }
      return;
    }
    // As Run::turns(), but with a branch for each outcome: most samples change nothing.
    const Run now = run();
    const std::int32_t value = now.mirrored(sample);
    if (value > now.extremum) {
      extremum_.set_relaxed(value);
    } else if (static_cast<std::uint32_t>(now.extremum) - static_cast<std::uint32_t>(value) >=
               hysteresis.raw()) {
      lock_.begin();
      set_run({~now.mirror, -value});
      confirmed(now.candidate());
      lock_.end();
    }
  }

  /// What a reader on another core has to look at before and after it reads.
  [[nodiscard]] const TurnLock& lock() const { return lock_; }

  /// True once there is a candidate beside a confirmed turning point.
  [[nodiscard]] bool directed() const { return phase_.relaxed() == kDirected; }
  /// The sample furthest from no tension, where none has a direction yet; no tension before the
  /// first and once there is one.
  [[nodiscard]] Tension held() const {
    if (phase_.relaxed() != kUndirected) {
      return {};
    }
    const std::int32_t highest = extremum_.relaxed();
    const std::int32_t lowest = lowest_.relaxed();
    return Tension::from_raw(highest > -lowest ? highest : lowest);
  }
  /// @pre directed()
  [[nodiscard]] Run run() const { return {mirror_.relaxed(), extremum_.relaxed()}; }
  /// @pre directed()
  void set_run(Run run) {
    mirror_.set_relaxed(run.mirror);
    extremum_.set_relaxed(run.extremum);
  }

  /// The whole state as plain words, for storage.
  struct State {
    std::uint32_t phase;
    std::int32_t mirror;
    std::int32_t extremum;
    std::int32_t lowest;
  };
  [[nodiscard]] State state() const {
    return {phase_.own(), mirror_.own(), extremum_.own(), lowest_.own()};
  }
  static constexpr bool directed(const State& s) { return s.phase == kDirected; }
  /// Whether push() could have left this state.
  static constexpr bool plausible(const State& s) {
    return s.phase <= kDirected && (s.mirror == 0 || s.mirror == -1) &&
           Tension::checked(s.extremum) && Tension::checked(s.lowest) &&
           (s.phase == kDirected || s.mirror == 0) &&
           (s.phase != kUndirected || s.lowest <= s.extremum);
  }
  /// @pre plausible(s)
  void restore(const State& s) {
    phase_.set_relaxed(s.phase);
    set_run({s.mirror, s.extremum});
    lowest_.set_plain(s.lowest);
  }

 private:
  static constexpr std::uint32_t kEmpty = 0;
  static constexpr std::uint32_t kUndirected = 1;
  static constexpr std::uint32_t kDirected = 2;

  template <class Confirmed>
  void seek_direction(std::int32_t value, TensionRange hysteresis, Confirmed&& confirmed) {
    const std::int32_t highest = extremum_.own();
    if (value > highest) {
      extremum_.set_relaxed(value);
      if (spread() >= hysteresis.raw()) {
        direct({0, value}, lowest_.own(), confirmed);
      }
    } else if (value < lowest_.own()) {
      lowest_.set_plain(value);
      if (spread() >= hysteresis.raw()) {
        direct({-1, -value}, highest, confirmed);
      }
    }
  }

  void start(std::int32_t value) {
    extremum_.set_relaxed(value);
    lowest_.set_plain(value);
    phase_.set_relaxed(kUndirected);
  }

  template <class Confirmed>
  void direct(Run run, std::int32_t first, Confirmed&& confirmed) {
    lock_.begin();
    lowest_.set_plain(0);
    set_run(run);
    phase_.set_relaxed(kDirected);
    confirmed(Tension::from_raw(first));
    lock_.end();
  }

  [[nodiscard]] std::uint32_t spread() const {
    return static_cast<std::uint32_t>(extremum_.own()) - static_cast<std::uint32_t>(lowest_.own());
  }

  TurnLock lock_;
  SharedWord<std::uint32_t> phase_{kEmpty};
  SharedWord<std::int32_t> mirror_;
  SharedWord<std::int32_t> extremum_;  ///< of the run; the maximum before the first direction
  SharedWord<std::int32_t> lowest_;    ///< the minimum before the first direction
};

}  // namespace lifemodel
