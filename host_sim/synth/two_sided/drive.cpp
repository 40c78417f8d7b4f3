#include "host_sim/synth/two_sided/drive.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "host_sim/synth/tension/recorder.hpp"

namespace host_sim::synth {

namespace {

// Far beyond what can be recorded, so that forces that run away end there.
constexpr double kMostForce_N = 1e12;

double bounded_N(double force_N) {
  return std::clamp(force_N, -kMostForce_N, kMostForce_N);
}

/// dT/dphi = slip mu (|T| / T_0)^-k |T| from one end of the sheath to the other: |T|^k, with the
/// sign of T, changes by the same for each radian, through zero as well where k is above 0.
double through_sheath_N(double force_N, double slip_mu, double angle_rad,
                        const TwoSidedEffects& effects) {
  constexpr double kLeastExponent = 1e-6;  // |T|^k of less tells no forces apart
  const double k = effects.load_exponent;
  const double side = force_N < 0 ? -1 : 1;
  if (std::abs(k) < kLeastExponent) {
    return bounded_N(force_N * std::exp(side * slip_mu * angle_rad));
  }
  if (k < 0 && force_N == 0) {
    return 0;
  }
  const double power = side * std::pow(std::abs(force_N), k) +
                       k * slip_mu * std::pow(effects.load_reference_N, k) * angle_rad;
  if (k < 0 && power * side <= 0) {
    return side * kMostForce_N;  // friction grows faster than the force
  }
  return bounded_N((power < 0 ? -1 : 1) * std::pow(std::abs(power), 1 / k));
}

/// The root above 0 of a rising function that is below zero at 0.
template <class Function>
double root_above_zero(double step, const Function& function) {
  constexpr int kDigits = 40;
  double low = 0;
  double high = step;
  while (function(high) < 0) {
    low = high;
    step *= 2;
    high += step;
  }
  std::uintmax_t most = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(kDigits), most);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

double TwoSidedContact::slip_after(double slide_m) const {
  if (slide_m == 0) {
    return slip_;
  }
  const double end = slide_m > 0 ? 1 : -1;
  return effects_.presliding_m > 0
             ? end + (slip_ - end) * std::exp(-std::abs(slide_m) / effects_.presliding_m)
             : end;
}

double TwoSidedContact::sliding_N(const Covariates& covariates, double slip, double slide_m) const {
  const double from_bump = (covariates.position_m - effects_.bump_centre_m) / effects_.bump_width_m;
  const double more = (1 + effects_.bump * std::exp(-from_bump * from_bump / 2)) *
                      (slip > 0 ? 1 + effects_.one_way : 1);
  const double velocity_m_s = covariates.step_s > 0 ? slide_m / covariates.step_s : 0;
  return through_sheath_N(covariates.output_tension_N, slip * mu_ * more, covariates.bend_angle_rad,
                          effects_) +
         effects_.preload_N * slip * more + effects_.viscous_N_s_m * velocity_m_s;
}

/// The spring holds what it held before, and what it is stretched by beyond what slides.
double TwoSidedContact::stretched_N(const Covariates& covariates, double travel_m) {
  const double k = effects_.stiffness_N_m;
  for (const double side : {1.0, -1.0}) {
    const auto beyond_N = [&](double slid_m) {
      const bool rigid_and_still = slid_m == 0 && effects_.presliding_m == 0;
      const double slip = rigid_and_still ? side : slip_after(side * slid_m);
      const double spring_N = force_N_ + k * (travel_m - side * slid_m);
      return side * (sliding_N(covariates, slip, side * slid_m) - spring_N);
    };
    if (beyond_N(0) < 0) {
      const double slide_m = side * root_above_zero(std::abs(travel_m) + 1e-9, beyond_N);
      slip_ = slip_after(slide_m);
      return sliding_N(covariates, slip_, slide_m);
    }
  }
  return force_N_ + k * travel_m;
}

double TwoSidedContact::step(const Covariates& covariates) {
  const double reached_m = taken_m_ + covariates.travel_m;
  taken_m_ = std::clamp(reached_m, 0.0, effects_.play_m);
  const double travel_m = reached_m - taken_m_;
  if (taken_m_ > 0 && taken_m_ < effects_.play_m) {
    force_N_ = covariates.output_tension_N;
  } else if (!begun_ || std::isinf(effects_.stiffness_N_m)) {
    slip_ = slip_after(travel_m);
    force_N_ = sliding_N(covariates, slip_, travel_m);
  } else {
    force_N_ = stretched_N(covariates, travel_m);
  }
  begun_ = true;
  const double drift = -effects_.creep * std::expm1(-covariates.time_s / effects_.creep_time_s);
  return (force_N_ + effects_.moved_kg * covariates.acceleration_m_s2) * (1 + drift);
}

namespace {

/// A sensor that follows by a first-order lag, exact where the force goes on a line.
class LaggingSensor {
 public:
  explicit LaggingSensor(double lag_s) : lag_s_(lag_s) {}

  double read(double value, double step_s) {
    if (lag_s_ <= 0 || step_s <= 0) {
      behind_ = 0;
    } else {
      const double settled = lag_s_ * (value - last_) / step_s;
      behind_ = settled + (behind_ - settled) * std::exp(-step_s / lag_s_);
    }
    last_ = value;
    return value - behind_;
  }

 private:
  double lag_s_;
  double last_ = 0;
  double behind_ = 0;
};

class TwoSidedSession {
 public:
  TwoSidedSession(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                  const TwoSidedEffects& effects, const Instants& instants, Channels& channels)
      : rig_(rig),
        setting_(setting),
        gain_(std::exp(scatter.log_gain)),
        effects_(effects),
        contact_(rig.friction_coefficient + scatter.friction, effects),
        output_sensor_(effects.output_lag_s),
        input_sensor_(effects.input_lag_s),
        recorder_(rig, instants, channels) {}

  void run() {
    recorder_.run([&](double time_s) { go_to(time_s); }, [&] { recorder_.sample(covariates_); });
  }

 private:
  void go_to(double time_s) {
    move_to(time_s, rig_.motion, setting_, covariates_);
    const double step_s = covariates_.step_s;
    const double at_drive_N = input_sensor_.read(contact_.step(covariates_), step_s);
    const double at_load_N = output_sensor_.read(covariates_.output_tension_N, step_s);
    pass(recorder_.output, time_s, effects_.output_delay_s,
         gain_ * (at_load_N + effects_.output_zero_N));
    pass(recorder_.input, time_s, effects_.input_delay_s, at_drive_N);
    if (rig_.drive) {
      const Model::Drive& drive = *rig_.drive;
      const double torque_Nm =
          at_drive_N * drive.spool_radius_m() / (drive.gear_ratio * drive.gear_efficiency);
      pass(recorder_.current, time_s, effects_.input_delay_s,
           torque_Nm / drive.torque_constant_Nm_per_A + drive.current_offset_A);
    }
  }

  /// A late channel shows what was; before the session that is what it begins with.
  static void pass(Reader& reader, double time_s, double delay_s, double value) {
    if (time_s == 0) {
      reader.pass(0, value);
    }
    reader.pass(time_s + delay_s, value);
  }

  const Rig& rig_;
  const Setting& setting_;
  double gain_;
  const TwoSidedEffects& effects_;
  TwoSidedContact contact_;
  LaggingSensor output_sensor_, input_sensor_;
  Recorder recorder_;
  Covariates covariates_;
};

}  // namespace

Channels simulate_two_sided(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                            const TwoSidedEffects& effects, const Instants& instants) {
  Channels channels;
  TwoSidedSession(rig, setting, scatter, effects, instants, channels).run();
  return channels;
}

}  // namespace host_sim::synth
