#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host_sim/effects/tension/forward.hpp"

/// What friction remembers of the motion from sample to sample.
namespace host_sim::effects {

/// How far friction is turned over once the tendon has slid further.
/// @param side the way it slides, -1 or 1
/// @param presliding_m the length that it turns over by; 0: at once
inline double turned_further(double turned, double side, double slid_m, double presliding_m) {
  return presliding_m > 0 ? side + (turned - side) * std::exp(-slid_m / presliding_m) : side;
}

/// How far friction is turned over, -1 .. 1, with its memory of the motion.
class Slip {
 public:
  Slip(const ForceRecord& record, const Kinematics& kinematics, const ForceValues& values)
      : record_(record),
        kinematics_(kinematics),
        values_(values),
        before_m_(record.position_m.front()) {}

  /// @param i the next sample
  /// @param presliding_m the length that friction turns over by there; 0: at once
  void go_to(std::size_t i, double presliding_m) {
    move_by(record_.reversal_m[i] - before_m_, presliding_m);
    move_by(record_.position_m[i] - record_.reversal_m[i], presliding_m);
    before_m_ = record_.position_m[i];
    slip_ = kinematics_.turned_over[i];
    if (values_.slack_m > 0) {
      slip_ = std::abs(taken_up_) == 1 && taken_up_ * slip_ > 0 ? slip_ : 0;
    }
    if (presliding_m > 0) {
      slip_ = presliding_;
    }
  }

  [[nodiscard]] double slip() const { return slip_; }

  /// Friction with a memory begins with what its first sample has.
  void begin(double turned) { presliding_ = turned; }
  [[nodiscard]] double turned() const { return presliding_; }

  /// Whether the tendon lies loose between two ends of its dead zone.
  [[nodiscard]] bool loose() const { return values_.loose_m > 0 && std::abs(taken_up_) < 1; }

 private:
  void move_by(double moved_m, double presliding_m) {
    if (moved_m == 0) {
      return;
    }
    for (const double play_m : {values_.slack_m, values_.loose_m}) {
      if (play_m > 0) {
        taken_up_ = std::clamp(taken_up_ + 2 * moved_m / play_m, -1.0, 1.0);
      }
    }
    if (presliding_m > 0) {
      presliding_ =
          turned_further(presliding_, moved_m > 0 ? 1 : -1, std::abs(moved_m), presliding_m);
    }
  }

  const ForceRecord& record_;
  const Kinematics& kinematics_;
  const ForceValues& values_;
  double before_m_;
  double slip_ = 0;
  double taken_up_ = 0;
  double presliding_ = 0;
};

/// A tendon that stretches between the drive and where it slides: the input follows the spring, and
/// never leaves what friction holds.
class Spring {
 public:
  Spring(const ForceRecord& record, const Forward& forward, const ForceValues& values)
      : record_(record),
        forward_(forward),
        stiffness_N_m_(values.stiffness_N_m),
        at_once_(!forward.is_of_speed() && values.presliding_m == 0 && values.presliding_N_m == 0) {
  }

  void begin(const Forward::Sample& of, double held_N, double turned) {
    now_ = of;
    held_N_ = held_N;
    turned_ = turned;
  }

  /// @param i the next sample
  void go_to(std::size_t i, const Forward::Sample& of, bool loose);

  [[nodiscard]] double held_N() const { return held_N_; }

 private:
  /// Between a sample and the one before it.
  struct Place {
    double share;
    bool loose;
  };

  [[nodiscard]] double force_N(const Place& at, double turned, double speed_m_s) const;
  void move_by(const Place& at, double moved_m, double time_s);

  const ForceRecord& record_;
  const Forward& forward_;
  double stiffness_N_m_;
  bool at_once_;
  Forward::Sample before_{};
  Forward::Sample now_{};
  double held_N_ = 0;
  double turned_ = 0;
};

}  // namespace host_sim::effects
