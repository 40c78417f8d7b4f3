#include "host_sim/effects/tension/force_model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace host_sim::effects {
namespace {

constexpr double kMostLogRatio = 5;
/// Of the scale of force: where friction that depends on load stops to grow.
constexpr double kLeastLoad = 0.01;
constexpr double kReference_C = 20;
constexpr double kReference_cycles = 1000;

/// How far friction is turned over once the tendon has slid further.
/// @param side the way it slides, -1 or 1
/// @param presliding_m the length that it turns over by; 0: at once
double turned_further(double turned, double side, double slid_m, double presliding_m) {
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

/// A sensor that follows by a first-order lag, exact where the force goes on a line or in one step.
class Lag {
 public:
  explicit Lag(double lag_s) : lag_s_(lag_s) {}

  /// @param since_s the time since the force stepped, after the sample before; none: on a line
  double read(double force_N, double time_s, std::optional<double> since_s) {
    const double step_s = time_s - before_s_;
    if (begun_ && step_s > 0 && since_s) {
      behind_N_ = behind_N_ * std::exp(-step_s / lag_s_) +
                  (force_N - last_N_) * std::exp(-*since_s / lag_s_);
    } else if (begun_ && step_s > 0) {
      const double settled_N = lag_s_ * (force_N - last_N_) / step_s;
      behind_N_ = settled_N + (behind_N_ - settled_N) * std::exp(-step_s / lag_s_);
    }
    begun_ = true;
    before_s_ = time_s;
    last_N_ = force_N;
    return force_N - behind_N_;
  }

 private:
  double lag_s_;
  bool begun_ = false;
  double before_s_ = 0;
  double last_N_ = 0;
  double behind_N_ = 0;
};

/// The time since the motion turned or set in, where it did since the sample before.
std::optional<double> since_reversal_s(const ForceRecord& record, std::size_t i) {
  const double before_m_s = record.velocity_m_s[i - 1];
  const double after_m_s = record.velocity_m_s[i];
  if (before_m_s * after_m_s > 0 || before_m_s == after_m_s) {
    return std::nullopt;
  }
  return (record.time_s[i] - record.time_s[i - 1]) * after_m_s / (after_m_s - before_m_s);
}

/// ln(T_in/T_out) of dT/dphi = mu (T/T_0)^-k T, for that of the output's friction all along.
double along_sheath(double log_ratio, double load_exponent) {
  constexpr double kLeast = 1e-9;  // nothing is left of the force
  return load_exponent == 0
             ? log_ratio
             : std::log1p(std::max(load_exponent * log_ratio, kLeast - 1)) / load_exponent;
}

/// Where what rises changes its sign between 0 and an end; 0 where it is not negative there, the
/// end where it is not positive there.
template <class Excess>
double root_between_0_and(double end, const Excess& excess) {
  constexpr int kMostSteps = 40;
  constexpr double kEnough = 1e-9;  // of what it rises by
  double low = 0;
  double at_low = excess(low);
  if (at_low >= 0) {
    return 0;
  }
  double high = end;
  double at_high = excess(high);
  if (at_high <= 0) {
    return end;
  }
  const double enough = kEnough * (at_high - at_low);
  // By secants, of which an end that stays counts half (Illinois).
  int kept = 0;
  double middle = end;
  for (int step = 0; step < kMostSteps; ++step) {
    middle = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_middle = excess(middle);
    if (std::abs(at_middle) < enough) {
      break;
    }
    if (at_middle < 0) {
      low = middle;
      at_low = at_middle;
      at_high /= kept == -1 ? 2 : 1;
      kept = -1;
    } else {
      high = middle;
      at_high = at_middle;
      at_low /= kept == 1 ? 2 : 1;
      kept = 1;
    }
  }
  return middle;
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

ForceValues values_of(const ForceTerms& terms, const ForceScales& scales,
                      std::span<const double> parameters) {
  ForceValues values;
  values.gain = parameters[0];
  values.friction = parameters[1];
  std::size_t next = 2;
  for (const ForceTerm term : terms) {
    const std::size_t count = parameters_of(term, scales).size();
    law_of(term).set(parameters.subspan(next, count), values);
    next += count;
  }
  return values;
}

/// Of the time since the sample before, when the motion turned; 1: it did not.
double turned_at(const ForceRecord& record, std::size_t i) {
  if (record.reversal_m[i] == record.position_m[i]) {
    return 1;
  }
  const double before_m_s = record.velocity_m_s[i - 1];
  const double after_m_s = record.velocity_m_s[i];
  constexpr double kMiddle = 0.5;  // it turned twice
  return before_m_s * after_m_s < 0 ? before_m_s / (before_m_s - after_m_s) : kMiddle;
}

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
  void go_to(std::size_t i, const Forward::Sample& of, bool loose) {
    before_ = std::exchange(now_, of);
    const double turned_at = effects::turned_at(record_, i);
    const double step_s = record_.time_s[i] - record_.time_s[i - 1];
    const double reversal_m = record_.reversal_m[i];
    move_by({turned_at, loose}, reversal_m - record_.position_m[i - 1], turned_at * step_s);
    if (turned_at < 1) {
      move_by({1, loose}, record_.position_m[i] - reversal_m, (1 - turned_at) * step_s);
    }
  }

  [[nodiscard]] double held_N() const { return held_N_; }

 private:
  /// Between a sample and the one before it.
  struct Place {
    double share;
    bool loose;
  };

  [[nodiscard]] double force_N(const Place& at, double turned, double speed_m_s) const {
    const auto of_sample_N = [&](const Forward::Sample& of) {
      return forward_.input_N(of, forward_.friction(of, speed_m_s), turned, at.loose);
    };
    return at.share < 1 ? std::lerp(of_sample_N(before_), of_sample_N(now_), at.share)
                        : of_sample_N(now_);
  }

  void move_by(const Place& at, double moved_m, double time_s) {
    const double stretched_N = held_N_ + stiffness_N_m_ * moved_m;
    if (at_once_ || moved_m == 0) {
      const auto [low_N, high_N] = std::minmax({force_N(at, -1, 0), force_N(at, 1, 0)});
      held_N_ = std::clamp(stretched_N, low_N, high_N);
      return;
    }
    const double side = moved_m > 0 ? 1 : -1;
    const double presliding_m = forward_.presliding_m(now_, forward_.friction(now_, 0));
    const auto sliding_N = [&](double slid_m) {
      return force_N(at, turned_further(turned_, side, slid_m, presliding_m), slid_m / time_s);
    };
    const double slid_m = root_between_0_and(std::abs(moved_m), [&](double slid) {
      return side * (sliding_N(slid) - stretched_N) + stiffness_N_m_ * slid;
    });
    if (slid_m > 0) {
      held_N_ = sliding_N(slid_m);
      turned_ = turned_further(turned_, side, slid_m, presliding_m);
    } else {
      const double back_N = force_N(at, -side, 0);
      held_N_ = side > 0 ? std::max(stretched_N, back_N) : std::min(stretched_N, back_N);
    }
  }

  const ForceRecord& record_;
  const Forward& forward_;
  double stiffness_N_m_;
  bool at_once_;
  Forward::Sample before_{};
  Forward::Sample now_{};
  double held_N_ = 0;
  double turned_ = 0;
};

void predict_in_time(const ForceRecord& record, const Kinematics& kinematics,
                     const ForceValues& values, const ForceScales& scales,
                     std::vector<double>& input_N) {
  input_N.resize(record.samples());
  if (input_N.empty()) {
    return;
  }
  const Forward forward(record, kinematics, values, scales);
  Slip slip(record, kinematics, values);
  Spring spring(record, forward, values);
  Lag lag(-values.lag_s);
  const bool at_once =
      values.stiffness_N_m == 0 && values.presliding_m == 0 && values.presliding_N_m == 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    const Forward::Sample of = forward.sample(i);
    const Forward::Friction friction = forward.friction(of, std::abs(record.velocity_m_s[i]));
    const bool remembers = !at_once && i == 0;
    if (remembers) {
      slip.begin(forward.turned_at(i, of, friction));
    }
    slip.go_to(i, forward.presliding_m(of, friction));
    double held_N = 0;
    if (values.stiffness_N_m > 0 && i > 0) {
      spring.go_to(i, of, slip.loose());
      held_N = spring.held_N();
    } else {
      const double turned = remembers ? slip.turned() : slip.slip();
      held_N = forward.input_N(of, friction, turned, slip.loose());
      spring.begin(of, held_N, turned);
    }
    input_N[i] = forward.shown_N(i, held_N);
    if (values.lag_s < 0) {
      input_N[i] = lag.read(input_N[i], record.time_s[i],
                            at_once && i > 0 ? since_reversal_s(record, i) : std::nullopt);
    }
  }
}

}  // namespace

double step_of(const ForceParameter& parameter, double value) {
  constexpr double kFine = 1e-5;  // relative
  constexpr double kWide = 0.05;
  const double step = (parameter.stepped ? kWide : kFine) *
                      std::max(std::abs(value), std::abs(parameter.starts.front()));
  return value + step > parameter.maximum ? -step : step;
}

void predict_input(const ForceRecord& record, const Kinematics& kinematics, const ForceTerms& terms,
                   const ForceScales& scales, std::span<const double> parameters,
                   std::vector<double>& input_N) {
  const ForceValues values = values_of(terms, scales, parameters);
  if (values.delay_s == 0 || record.samples() < 2) {
    predict_in_time(record, kinematics, values, scales, input_N);
    return;
  }
  const auto [read, moved] = read_later(record, kinematics, scales, values.delay_s);
  predict_in_time(read, moved ? *moved : kinematics, values, scales, input_N);
}

bool position_slopes(const ForceRecord& record, const Kinematics& kinematics,
                     const ForceTerms& terms, const ForceScales& scales,
                     std::span<const double> parameters, std::span<const double> at_N,
                     std::size_t place, std::vector<double>& slopes_N) {
  if (terms[place] != ForceTerm::position && terms[place] != ForceTerm::position_from_middle) {
    return false;
  }
  ForceValues values = values_of(terms, scales, parameters);
  if (values.stiffness_N_m > 0 || values.presliding_N_m > 0 || values.lag_s < 0 ||
      values.delay_s != 0) {
    return false;
  }
  constexpr double kStep = 1e-6;
  std::vector<double> above_N;
  values.evenly = kStep;
  predict_in_time(record, kinematics, values, scales, above_N);
  slopes_N.clear();
  for (std::size_t i = 0; i < at_N.size(); ++i) {
    const double by_share_N = (above_N[i] - at_N[i]) / kStep;
    each_wave(kinematics, values.from_middle, i,
              [&](std::size_t, double wave) { slopes_N.push_back(wave * by_share_N); });
  }
  return true;
}

}  // namespace host_sim::effects
