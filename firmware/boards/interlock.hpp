#pragma once

#include <cstdint>

#include "hal/devices.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace boards {

/// Stands between the application and the lines that keep people safe, so that an emergency stop
/// takes the drive away in the period of the control loop that sees it, whatever the application
/// waits for.
///
/// All lines are read and set by the control loop alone. The application's drive enable, brake and
/// emergency stop are the three parts below; they never wait. Nothing is let go before
/// `kPeriodsInTime` periods of the loop in a row came in time. From the first sight of a stop the
/// drive stays off and the brake on until the next start. A stop that cannot be read is a stop.
///
/// Lines: the outputs `drive_enable` and `brake`, and the input `emergency_stop`.
template <class LinesT, std::uint32_t kPeriodsInTime>
class Interlock {
 public:
  explicit Interlock(LinesT& lines) : lines_(lines) {}

  /// Drive enable of the application.
  class Drive {
   public:
    explicit Drive(Interlock& interlock) : interlock_(interlock) {}
    hal::Error set(bool on) {
      interlock_.want_drive_.set_relaxed(on);
      return interlock_.error_.relaxed();
    }

   private:
    Interlock& interlock_;
  };

  /// Brake of the application.
  class Brake {
   public:
    explicit Brake(Interlock& interlock) : interlock_(interlock) {}
    hal::Error set(bool on) {
      interlock_.want_brake_.set_relaxed(on);
      return interlock_.error_.relaxed();
    }

   private:
    Interlock& interlock_;
  };

  /// Emergency stop of the application: asserted now, or at any time since the last look.
  class Stop {
   public:
    explicit Stop(Interlock& interlock) : interlock_(interlock) {}
    hal::Result<bool> asserted() {
      const State state = interlock_.state_.acquire();
      if (state == State::unknown || state == State::unreadable) {
        return state == State::unknown ? hal::Error::off : hal::Error::failed;
      }
      const std::uint32_t pulls = interlock_.pulls_.relaxed();
      const bool was = pulls != seen_pulls_;
      seen_pulls_ = pulls;
      return was || state == State::pulled;
    }

   private:
    Interlock& interlock_;
    std::uint32_t seen_pulls_ = 0;
  };

  /// In each period of the control loop; `in_time`: it came one period after the one before it.
  /// Once before the application starts, for it asks for the stop then.
  void isr_apply(bool in_time) {
    if (periods_in_time_ < kPeriodsInTime) {
      periods_in_time_ = in_time ? periods_in_time_ + 1 : 0;
    }
    const hal::Result<bool> stop = lines_.emergency_stop.asserted();
    const bool pulled = !stop || *stop;
    tripped_ = tripped_ || pulled;
    const bool held = tripped_ || periods_in_time_ < kPeriodsInTime;
    put(want_drive_.relaxed() && !held, want_brake_.relaxed() || held);
    // After the lines, so that who hears of the stop also hears whether they obeyed.
    pulls_.set_relaxed(pulls_.own() + (pulled ? 1 : 0));
    state_.release(!stop ? State::unreadable : pulled ? State::pulled : State::released);
  }

  /// Drive off and brake on for good, for the way down. The control loop must have ended.
  hal::Error lock() {
    tripped_ = true;
    isr_apply(false);
    return error_.own();
  }

 private:
  enum class State : std::uint8_t { unknown, unreadable, pulled, released };

  void put(bool drive, bool brake) {
    if (drive == drive_ && brake == brake_ && error_.own() == hal::Error::none) {
      return;
    }
    drive_ = drive;
    brake_ = brake;
    error_.set_relaxed(hal::set_motion(lines_.drive_enable, drive, lines_.brake, brake));
  }

  LinesT& lines_;
  // Of the application.
  lifemodel::SharedWord<bool> want_drive_{false};
  lifemodel::SharedWord<bool> want_brake_{true};
  // Of the control loop.
  lifemodel::SharedWord<std::uint32_t> pulls_;  ///< periods with a stop; wraps
  lifemodel::SharedWord<State> state_{State::unknown};
  lifemodel::SharedWord<hal::Error> error_{hal::Error::off};  // until the lines are set
  std::uint32_t periods_in_time_ = 0;                         ///< in a row, up to kPeriodsInTime
  bool tripped_ = false;
  bool drive_ = false;
  bool brake_ = true;
};

}  // namespace boards
