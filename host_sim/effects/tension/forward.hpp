#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::effects {

/// ln(T_in/T_out) of dT/dphi = mu (T/T_0)^-k T, for that of the output's friction all along.
inline double along_sheath(double log_ratio, double load_exponent) {
  constexpr double kLeast = 1e-9;  // nothing is left of the force
  return load_exponent == 0
             ? log_ratio
             : std::log1p(std::max(load_exponent * log_ratio, kLeast - 1)) / load_exponent;
}

/// Calls wave(k, value) for the sine and the cosine of each harmonic of a sample's place, in the
/// order of ForceValues::harmonics.
template <class Wave>
void each_wave(const Kinematics& kinematics, bool from_middle, std::size_t i, const Wave& wave) {
  double first_sine = kinematics.place_sine[i];
  double first_cosine = kinematics.place_cosine[i];
  if (from_middle) {
    first_sine = kinematics.place_sine[i] * kinematics.middle_cosine -
                 kinematics.place_cosine[i] * kinematics.middle_sine;
    first_cosine = kinematics.place_cosine[i] * kinematics.middle_cosine +
                   kinematics.place_sine[i] * kinematics.middle_sine;
  }
  // Each harmonic by the one before it: sin((k + 1) x) is sin(k x) cos x + cos(k x) sin x.
  double sine = 0;
  double cosine = 1;
  for (std::size_t k = 0; k < 2 * ForceValues::kHarmonics; k += 2) {
    const double next = sine * first_cosine + cosine * first_sine;
    cosine = cosine * first_cosine - sine * first_sine;
    sine = next;
    wave(k, sine);
    wave(k + 1, cosine);
  }
}

/// What each sample has beside how far its friction is turned over.
class Forward {
 public:
  Forward(const ForceRecord& record, const Kinematics& kinematics, const ForceValues& values,
          const ForceScales& scales)
      : record_(record),
        kinematics_(kinematics),
        values_(values),
        scales_(scales),
        by_position_(values.harmonics != decltype(values.harmonics){}),
        by_load_(values.by_load != decltype(values.by_load){}),
        by_speed_(values.by_speed != decltype(values.by_speed){}) {}

  /// What a sample has whatever its friction is turned over by, and however fast the tendon slides.
  struct Sample {
    double output_N;
    double place;  ///< of the friction, as its place has it
    double age;
    double warm;
    double along;  ///< what a coefficient of the sheath's friction goes with
  };

  /// What rubs where it is turned over in full.
  struct Friction {
    double log_ratio;  ///< of the sheath
    double other_N;    ///< beside it
  };

  [[nodiscard]] Sample sample(std::size_t i) const {
    Sample of{.output_N = output_of_tendon_N(i),
              .place = position_factor(i),
              .age = age_factor(i),
              .warm = 1,
              .along = angle_rad(i)};
    const double size_N = std::abs(of.output_N);
    if (values_.temperature_1_K != 0) {
      of.warm += values_.temperature_1_K * (record_.sheath_temperature_C[i] - kReference_C);
    }
    of.along *= of.warm;
    if (by_load_) {
      of.along *= load_factor(size_N);
    }
    if (values_.giving_share != 0) {
      of.along *= std::max(0.0, 1 + values_.giving_share * (size_N / scales_.force_N - 1));
    }
    if (values_.load_exponent != 0) {
      of.along *= std::pow(std::max(size_N / scales_.force_N, kLeastLoad), -values_.load_exponent);
    }
    return of;
  }

  [[nodiscard]] Friction friction(const Sample& of, double speed_m_s) const {
    const double place = of.place * (by_speed_ ? speed_factor(speed_m_s) : 1);
    double coefficient =
        values_.friction * place * of.age + values_.viscous_friction_s_m * speed_m_s;
    if (values_.stribeck_friction != 0) {
      coefficient +=
          values_.stribeck_friction * std::exp(-speed_m_s / values_.stribeck_velocity_m_s);
    }
    return {coefficient * of.along,
            values_.preload_N * place * of.warm + values_.viscous_N_s_m * speed_m_s};
  }

  /// Input force before the gain, for a friction that is turned over by `slip`.
  /// @param loose whether the drive holds only a part of the force
  [[nodiscard]] double input_N(const Sample& of, const Friction& friction, double slip,
                               bool loose) const {
    const double way = slip * (1 + values_.one_way_share * slip);
    double log_ratio = friction.log_ratio * way;
    if (loose) {
      log_ratio = values_.loose_friction * log_ratio - values_.loose_log_drop;
    }
    // A force the other way round is that of the other tendon, whose motion is the other way too.
    const double side = of.output_N < 0 ? -1 : 1;
    const double ratio = std::exp(std::clamp(along_sheath(side * log_ratio, values_.load_exponent),
                                             -kMostLogRatio, kMostLogRatio));
    return of.output_N * ratio + friction.other_N * way;
  }

  /// Whether friction depends on how fast the tendon slides.
  [[nodiscard]] bool is_of_speed() const {
    return by_speed_ || values_.viscous_N_s_m != 0 || values_.viscous_friction_s_m != 0 ||
           values_.stribeck_friction != 0;
  }

  /// The length that friction turns over by; 0: at once.
  [[nodiscard]] double presliding_m(const Sample& of, const Friction& friction) const {
    if (values_.presliding_N_m == 0) {
      return values_.presliding_m;
    }
    constexpr double kLeast_m = 1e-9;
    const double friction_N = input_N(of, friction, 1, false) - of.output_N;
    return std::max(friction_N / values_.presliding_N_m, kLeast_m);
  }

  /// How far friction is turned over where the input force is as it was read: what went before is
  /// not known. 0 where that does not count, or nothing rubs.
  [[nodiscard]] double turned_at(std::size_t i, const Sample& of, const Friction& friction) const {
    constexpr double kNone = 1e-6;  // of the scale of force
    const double back_N = shown_N(i, input_N(of, friction, -1, false));
    const double rubs_N = shown_N(i, input_N(of, friction, 1, false)) - back_N;
    return record_.used[i] && rubs_N > kNone * scales_.force_N
               ? std::clamp(2 * (record_.input_N[i] - back_N) / rubs_N - 1, -1.0, 1.0)
               : 0;
  }

  /// What the drive has for a force: as a current shows it, with what is wrong with the motor.
  [[nodiscard]] double shown_N(std::size_t i, double force_N) const {
    double efficiency = 1;
    if (values_.gear_asymmetry != 0) {
      efficiency += values_.gear_asymmetry * kinematics_.turned_over[i];
    }
    if (values_.droop_1_K != 0) {
      constexpr double kLeastGain = 0.05;
      efficiency *= std::max(
          kLeastGain, 1 - values_.droop_1_K * (record_.winding_temperature_C[i] - kReference_C));
    }
    double off_A = values_.current_offset_A;
    if (values_.ripple_harmonic > 0) {
      const double phase = values_.ripple_harmonic * record_.rotor_rad[i];
      off_A -= values_.ripple_sine_A * std::sin(phase) + values_.ripple_cosine_A * std::cos(phase);
    }
    double gain = values_.gain / efficiency;
    if (values_.drift_share != 0) {
      gain *= 1 - values_.drift_share *
                      std::expm1((record_.time_s.front() - record_.time_s[i]) / values_.drift_s);
    }
    if (values_.warm_N_K != 0) {
      force_N += values_.warm_N_K * (record_.sheath_temperature_C[i] - kReference_C);
    }
    return gain * force_N + record_.input_N_per_A * off_A;
  }

 private:
  static constexpr double kMostLogRatio = 5;
  /// Of the scale of force: where friction that depends on load stops to grow.
  static constexpr double kLeastLoad = 0.01;
  static constexpr double kReference_C = 20;
  static constexpr double kReference_cycles = 1000;

  /// 1 at a half of the usual speed; what each end has beyond a knot stays.
  [[nodiscard]] double speed_factor(double speed_m_s) const {
    const auto& [at_rest, at_quarter, at_full] = values_.by_speed;
    const double quarters = std::min(4 * speed_m_s / scales_.speed_m_s, 4.0);
    return 1 + (quarters < 1   ? std::lerp(at_rest, at_quarter, quarters)
                : quarters < 2 ? std::lerp(at_quarter, 0.0, quarters - 1)
                               : at_full * (quarters - 2) / 2);
  }

  /// 1 at the root mean square of the load, on lines over its logarithm.
  [[nodiscard]] double load_factor(double load_N) const {
    const auto& [at_quarter, at_half, at_twice] = values_.by_load;
    const double doubled = std::clamp(std::log2(load_N / scales_.force_N), -2.0, 1.0);
    return 1 + (doubled < -1  ? std::lerp(at_half, at_quarter, -doubled - 1)
                : doubled < 0 ? -doubled * at_half
                              : doubled * at_twice);
  }

  [[nodiscard]] double position_factor(std::size_t i) const {
    double factor = 1 + values_.evenly;
    if (by_position_) {
      each_wave(kinematics_, values_.from_middle, i,
                [&](std::size_t k, double wave) { factor += values_.harmonics[k] * wave; });
    }
    return factor;
  }

  /// The output force without what is wrong with its sensor.
  [[nodiscard]] double output_of_tendon_N(std::size_t i) const {
    double output_N = record_.output_N[i] - values_.zero_N;
    if (values_.bent_share != 0) {
      output_N *= 1 + values_.bent_share * std::pow(output_N / scales_.force_N, 2);
    }
    if (values_.lag_s > 0) {
      output_N += values_.lag_s * record_.output_rate_N_s[i];
    }
    return output_N;
  }

  [[nodiscard]] double age_factor(std::size_t i) const {
    double factor = 1;
    if (values_.wear != 0) {
      factor +=
          values_.wear * std::pow(record_.cycle[i] / kReference_cycles, values_.wear_exponent);
    }
    if (values_.run_in != 0) {
      factor += values_.run_in * std::exp(-record_.cycle[i] / values_.run_in_cycles);
    }
    return std::max(factor, 0.0);
  }

  [[nodiscard]] double angle_rad(std::size_t i) const {
    const double nominal_rad = record_.bend_angle_rad[i];
    if (values_.pose_errors_rad.empty()) {
      return nominal_rad;
    }
    const std::size_t pose = kinematics_.pose[i];
    return std::max(
        0.0,
        nominal_rad + (pose < values_.pose_errors_rad.size() ? values_.pose_errors_rad[pose] : 0));
  }

  const ForceRecord& record_;
  const Kinematics& kinematics_;
  const ForceValues& values_;
  const ForceScales& scales_;
  bool by_position_;
  bool by_load_;
  bool by_speed_;
};

}  // namespace host_sim::effects
