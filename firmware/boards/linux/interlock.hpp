#pragma once

#include <atomic>

#include "hal/digital.hpp"
#include "hal/error.hpp"
#include "hal/result.hpp"

namespace board {

/// Stands between the application and the lines that keep people safe, so that an emergency stop
/// takes the drive away within one period of the control loop, whatever the application waits for.
///
/// All lines are read and set by the thread of the control loop alone. The application's drive
/// enable, brake and emergency stop are the three parts below; they never wait. From the first
/// sight of a stop the drive stays off and the brake on until the next start. A stop that cannot be
/// read is a stop.
///
/// Lines: `hal::Error set(drive, brake)` and `hal::Result<bool> stop_asserted()`.
template <class LinesT>
class Interlock {
 public:
  explicit Interlock(LinesT& lines) : lines_(lines) {}

  /// Drive enable of the application.
  class Drive {
   public:
    explicit Drive(Interlock& interlock) : interlock_(interlock) {}
    hal::Error set(bool on) {
      interlock_.want_drive_ = on;
      return interlock_.error_;
    }

   private:
    Interlock& interlock_;
  };

  /// Brake of the application.
  class Brake {
   public:
    explicit Brake(Interlock& interlock) : interlock_(interlock) {}
    hal::Error set(bool on) {
      interlock_.want_brake_ = on;
      return interlock_.error_;
    }

   private:
    Interlock& interlock_;
  };

  /// Emergency stop of the application: asserted now, or at any time since the last look.
  class Stop {
   public:
    explicit Stop(Interlock& interlock) : interlock_(interlock) {}
    hal::Result<bool> asserted() {
      if (interlock_.unreadable_) {
        return hal::Error::failed;
      }
      return interlock_.unseen_.exchange(false) || interlock_.pulled_;
    }

   private:
    Interlock& interlock_;
  };

  /// In each period of the control loop.
  void isr_apply() {
    const hal::Result<bool> stop = lines_.stop_asserted();
    unreadable_ = !stop;
    const bool pulled = !stop || *stop;
    pulled_ = pulled;
    if (pulled) {
      unseen_ = true;
      tripped_ = true;
    }
    put(want_drive_ && !tripped_, want_brake_ || tripped_);
  }

  /// Drive off and brake on for good, for the way down. The control loop must have ended.
  hal::Error lock() {
    tripped_ = true;
    isr_apply();
    return error_;
  }

 private:
  void put(bool drive, bool brake) {
    if (drive == drive_ && brake == brake_ && error_ == hal::Error::none) {
      return;
    }
    drive_ = drive;
    brake_ = brake;
    error_.store(lines_.set(drive, brake));
  }

  LinesT& lines_;
  // Of the application.
  std::atomic<bool> want_drive_{false};
  std::atomic<bool> want_brake_{true};
  // Of the control loop.
  std::atomic<bool> pulled_{false};
  std::atomic<bool> unseen_{false};
  std::atomic<bool> unreadable_{false};
  std::atomic<hal::Error> error_{hal::Error::off};  // until the lines are set for the first time
  bool tripped_ = false;
  bool drive_ = false;
  bool brake_ = true;
};

}  // namespace board
