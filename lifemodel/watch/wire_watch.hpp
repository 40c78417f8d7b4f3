#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/shared_word.hpp"
#include "lifemodel/watch/watch_limits.hpp"

namespace lifemodel {

/// What has happened to a wire besides its cycles. Counts wrap; they and the samples go on over
/// WireWatch::begin(), so that the difference of two readings is what lay between them.
struct WatchReading {
  static constexpr std::size_t kLevels = 3;

  std::uint32_t peak = 0;                      ///< the highest tension, Q29 as Tension
  std::uint32_t window_peak = 0;               ///< the same since begin_window()
  std::array<std::uint32_t, kLevels> above{};  ///< excursions above 50, 70 and 90 %
  std::uint32_t below_minimum = 0;             ///< samples below the minimum tension
  std::uint32_t slack_events = 0;
  bool slack = false;   ///< now
  bool broken = false;  ///< since begin(); stays

  friend constexpr bool operator==(const WatchReading&, const WatchReading&) = default;
};

/// Watches one wire for breaks, slack and peaks, sample by sample, in constant time.
///
/// A tension counts by its size: of two tendons that pull against each other, the negative one is
/// the other's.
///
/// Excursions: one begins when the tension reaches the level, and ends when it has come back from
/// the level by more than the hysteresis.
///
/// Slack: the tendon has moved over the slack travel, from one end to the other whatever the way,
/// and the tension was below the minimum all the while. Ends with the first sample that is not.
///
/// Broken: the motor has pulled over the broken travel, measured from where the tendon was furthest
/// released, and the tension was no more than friction alone makes all the while. A wire that is
/// whole takes up its slack in the same way, which is why the travel has to be more than that. A
/// wire that breaks is found once the next pull is that long; it cannot be told from slack before.
///
/// Slower motion than kStill counts as none, so that the zero error of a sensor is no travel. What
/// a gap leaves out is not known: a longer one than kLongestGap begins the travel anew. Without
/// motion there are neither breaks nor slack, only peaks and samples below the minimum.
///
/// push(), miss(), begin() and begin_window() belong to one side, the interrupt; reading() may be
/// called from the other.
class WireWatch {
 public:
  /// Of the excursions, relative to the ultimate tension.
  static constexpr std::array<std::uint32_t, WatchReading::kLevels> kLevels{1u << 28, 375809638u,
                                                                            483183821u};
  static constexpr Velocity kStill = Velocity::from_raw(16777);  ///< 1 mm/s
  static constexpr std::uint32_t kLongestGap = 16;               ///< samples

  WireWatch() = default;
  /// @param hysteresis of the excursions, that of the counting
  WireWatch(const WatchLimits& limits, TensionRange hysteresis, std::uint32_t sample_period_us)
      : minimum_(static_cast<std::uint32_t>(limits.minimum.raw())),
        friction_alone_(static_cast<std::uint32_t>(limits.broken.raw())),
        broken_travel_um_(limits.finds_broken() ? limits.broken_travel_um : 0),
        slack_travel_um_(limits.finds_slack() ? limits.slack_travel_um : 0),
        hysteresis_(hysteresis.raw()),
        period_us_(sample_period_us < kLongestPeriod_us ? sample_period_us : kLongestPeriod_us) {}

  /// Takes a sample of input tension, and the velocity of the tendon, positive while pulling; 0
  /// where it is not measured.
  void push(Tension tension, Velocity velocity = {}) {
    const std::uint32_t size = size_of(tension);
    if (size - floor_ >= width_) [[unlikely]] {
      take(size, velocity);
    }
  }

  /// Samples are missing.
  void miss(std::uint32_t samples) { gap_ = samples < ~gap_ ? gap_ + samples : ~0u; }

  /// A new wire: peak, break and what is under way are forgotten.
  void begin() {
    peak_.set_relaxed(0);
    state_.set_relaxed(0);
    above_ = 0;
    gap_ = 0;
    rest();
    begin_window();
  }
  /// The peak of a stretch of time is sought anew; all else goes on.
  void begin_window() {
    window_peak_.set_relaxed(0);
    width_ = 0;
  }

  [[nodiscard]] WatchReading reading() const {
    const std::uint32_t state = state_.relaxed();
    return {peak_.relaxed(),
            window_peak_.relaxed(),
            {counts_[0].relaxed(), counts_[1].relaxed(), counts_[2].relaxed()},
            below_minimum_.relaxed(),
            slack_events_.relaxed(),
            (state & kSlack) != 0,
            (state & kBroken) != 0};
  }
  /// Two of a reading, for who asks after each sample.
  [[nodiscard]] std::uint32_t slack_events() const { return slack_events_.relaxed(); }
  [[nodiscard]] bool broken() const { return (state_.relaxed() & kBroken) != 0; }

 private:
  static constexpr std::uint32_t kSlack = 1;
  static constexpr std::uint32_t kBroken = 2;
  static constexpr std::uint32_t kLongestPeriod_us = 1u << 30;

  static constexpr std::uint32_t size_of(Tension tension) {
    return static_cast<std::uint32_t>(tension.raw() < 0 ? -tension.raw() : tension.raw());
  }
  static constexpr std::int64_t travel_of(std::uint32_t travel_um) {
    return std::int64_t{travel_um} << Velocity::kFractionBits;
  }

  /// A sample outside the band in which there is nothing to note.
  [[gnu::noinline]] void take(std::uint32_t size, Velocity velocity) {
    if (size > window_peak_.own()) {
      window_peak_.set_relaxed(size);
      if (size > peak_.own()) {
        peak_.set_relaxed(size);
      }
    }
    climb(size);
    const std::uint32_t low = this->low();
    if (size < low) [[unlikely]] {
      take_low(size, velocity);
      width_ = 0;
      return;
    }
    if (width_ == 0) {
      rest();
      set(kSlack, false);
    }
    gap_ = 0;
    // The band reaches from floor_ up to, and without, the next peak or level.
    const std::uint32_t back = above_ == 0 ? 0 : end_of(above_ - 1);
    const std::uint32_t peak = window_peak_.own() + 1;
    const std::uint32_t level = above_ < kLevels.size() ? kLevels[above_] : peak;
    floor_ = back < low ? low : back;
    width_ = (peak < level ? peak : level) - floor_;
  }

  void climb(std::uint32_t size) {
    while (above_ < kLevels.size() && size >= kLevels[above_]) {
      counts_[above_].set_relaxed(counts_[above_].own() + 1);
      ++above_;
    }
    while (above_ > 0 && size < end_of(above_ - 1)) {
      --above_;
    }
  }
  /// Below it the excursion above a level is over.
  [[nodiscard]] std::uint32_t end_of(std::uint32_t level) const {
    return kLevels[level] - (hysteresis_ < kLevels[level] ? hysteresis_ : kLevels[level]);
  }

  /// The size below which each sample has to be looked at.
  [[nodiscard]] std::uint32_t low() const {
    const std::uint32_t broken = broken_travel_um_ != 0 ? friction_alone_ + 1 : 0;
    return minimum_ < broken ? broken : minimum_;
  }

  void take_low(std::uint32_t size, Velocity velocity) {
    if (gap_ > kLongestGap) {
      rest();
    }
    gap_ = 0;
    move(velocity);
    if (size < minimum_) {
      below_minimum_.set_relaxed(below_minimum_.own() + 1);
    } else {
      lowest_ = highest_ = position_;
      set(kSlack, false);
    }
    if (size > friction_alone_) {
      released_ = position_;
    }
    judge();
  }

  void move(Velocity velocity) {
    if (velocity <= kStill && velocity.raw() >= -kStill.raw()) {
      return;
    }
    // Beyond it everything is found.
    constexpr std::int64_t kMost = std::int64_t{1} << 61;
    position_ += std::int64_t{velocity.raw()} * static_cast<std::int32_t>(period_us_);
    position_ = position_ < -kMost ? -kMost : position_ > kMost ? kMost : position_;
    lowest_ = position_ < lowest_ ? position_ : lowest_;
    highest_ = position_ > highest_ ? position_ : highest_;
    released_ = position_ < released_ ? position_ : released_;
  }

  void judge() {
    if (broken_travel_um_ != 0 && position_ - released_ >= travel_of(broken_travel_um_)) {
      set(kBroken, true);
      set(kSlack, false);
    }
    if (state_.own() == 0 && slack_travel_um_ != 0 &&
        highest_ - lowest_ >= travel_of(slack_travel_um_)) {
      set(kSlack, true);
      slack_events_.set_relaxed(slack_events_.own() + 1);
    }
  }

  void set(std::uint32_t bit, bool there) {
    state_.set_relaxed(there ? state_.own() | bit : state_.own() & ~bit);
  }

  /// No travel is under way.
  void rest() {
    position_ = 0;
    lowest_ = 0;
    highest_ = 0;
    released_ = 0;
  }

  std::uint32_t minimum_ = 0;
  std::uint32_t friction_alone_ = 0;
  // 0: off.
  std::uint32_t broken_travel_um_ = 0;
  std::uint32_t slack_travel_um_ = 0;
  std::uint32_t hysteresis_ = 0;
  std::uint32_t period_us_ = 0;

  std::uint32_t floor_ = 0;
  std::uint32_t width_ = 0;  ///< 0: each sample is looked at
  std::uint32_t above_ = 0;  ///< how many levels have an excursion under way
  std::uint32_t gap_ = 0;
  // In um, Q24.
  std::int64_t position_ = 0;
  std::int64_t lowest_ = 0;    ///< since the tension was below the minimum
  std::int64_t highest_ = 0;   ///< the same
  std::int64_t released_ = 0;  ///< furthest, since the tension was more than friction alone makes

  SharedWord<std::uint32_t> peak_;
  SharedWord<std::uint32_t> window_peak_;
  SharedWord<std::uint32_t> state_;
  SharedWord<std::uint32_t> below_minimum_;
  SharedWord<std::uint32_t> slack_events_;
  std::array<SharedWord<std::uint32_t>, WatchReading::kLevels> counts_;
};

}  // namespace lifemodel
