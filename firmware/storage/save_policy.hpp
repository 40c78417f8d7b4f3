#pragma once

#include <cstdint>

#include "hal/clock.hpp"

namespace storage {

/// When to save: kPeriod after the last save where anything is unsaved; sooner, where the damage
/// has moved by kStep_ppb or something changed.
///
/// Sooner costs credit, so that writing is bounded whatever the damage does: in any span of time t
/// it asks for at most t / kPeriod + kCredit saves, and a save that fails counts as one. A fresh
/// start has little credit, or a controller that restarts over and over would wear the memory out.
/// The periodic save always has the credit it needs: it earns it during the period.
class SavePolicy {
 public:
  static constexpr hal::Time kPeriod = hal::seconds(60);
  static constexpr hal::Time kMinimumDistance = hal::seconds(1);
  static constexpr std::uint32_t kStep_ppb = 1'000;
  static constexpr std::uint32_t kCredit = 60;      ///< saves that can be ahead of the period
  static constexpr std::uint32_t kStartCredit = 4;  ///< of these, at a start

  /// What is stored is up to date.
  constexpr void start(hal::Time now) {
    last_ = now;
    paid_until_ = now + times(kPeriod, kCredit - kStartCredit);
  }

  /// Whether to save now. `unsaved_ppb` is not 0 where anything is unsaved.
  [[nodiscard]] constexpr bool due(hal::Time now, std::uint32_t unsaved_ppb, bool changed) const {
    if (now < last_ + kMinimumDistance) {
      return false;
    }
    if (unsaved_ppb != 0 && now >= last_ + kPeriod) {
      return true;
    }
    return (changed || unsaved_ppb >= kStep_ppb) && has_credit(now);
  }

  constexpr void saved(hal::Time now) { charge(now); }
  /// A save that failed may have worn the memory all the same.
  constexpr void failed(hal::Time now) { charge(now); }

 private:
  static constexpr hal::Time times(hal::Time span, std::uint32_t n) { return {span.us * n}; }

  [[nodiscard]] constexpr bool has_credit(hal::Time now) const {
    return paid_until_ + kPeriod <= now + times(kPeriod, kCredit);
  }
  constexpr void charge(hal::Time now) {
    last_ = now;
    const hal::Time from = paid_until_ > now ? paid_until_ : now;
    const hal::Time limit = now + times(kPeriod, kCredit);
    paid_until_ = from + kPeriod < limit ? from + kPeriod : limit;
  }

  hal::Time last_;
  hal::Time paid_until_;  ///< ahead of the time by one period for each save of credit in use
};

/// What pages of flash stand before they wear out, when each is erased as often as the others.
struct Wear {
  std::uint32_t pages = 16;
  std::uint32_t page_bytes = 2'048;
  std::uint32_t record_bytes = 88;
  std::uint32_t erases = 10'000;  ///< a page (STM32G431 data sheet, flash endurance)

  /// Records that can be written in all.
  [[nodiscard]] constexpr std::uint64_t writes() const {
    return std::uint64_t{pages} * (page_bytes / record_bytes) * erases;
  }
  /// Saves of that many tendons, one record each.
  [[nodiscard]] constexpr std::uint64_t saves(std::uint32_t tendons) const {
    return writes() / tendons;
  }
  /// How long that lasts, in tenths of a year of 365.25 days, rounded down.
  [[nodiscard]] constexpr std::uint64_t years_x10(std::uint32_t tendons,
                                                  std::uint32_t seconds_a_save) const {
    constexpr std::uint64_t kTenthOfYear_s = 3'155'760;
    return saves(tendons) * seconds_a_save / kTenthOfYear_s;
  }
};

}  // namespace storage
