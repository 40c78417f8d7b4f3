#include "host_sim/synth/tension/departures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host_sim/synth/draws.hpp"

namespace host_sim::synth {
namespace {

/// Wear: mu * (1 + a (n / n0)^p). Run-in: mu * (1 + a exp(-n / n0)).
class FrictionWear final : public TensionPart {
 public:
  explicit FrictionWear(const Values& values)
      : change_(values["change"]),
        reference_cycles_(values["reference_cycles"]),
        exponent_(values["exponent"]),
        run_in_(values.choice("law") == "run_in") {}

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    const double age = covariates.cycle / reference_cycles_;
    return mu * (1 + change_ * (run_in_ ? std::exp(-age) : std::pow(age, exponent_)));
  }

 private:
  double change_, reference_cycles_, exponent_;
  bool run_in_;
};

TensionKind friction_wear() {
  return {"friction_wear",
          {{{"change", "", {-0.9, 5}}},
           {{"reference_cycles", "cycles", {1, 1e9}}},
           {{"exponent", "", {0.05, 4}}, 1}},
          {{"law", {"wear", "run_in"}}},
          make_part<FrictionWear>};
}

/// mu * (1 + k (T_sheath - T_ref)).
class FrictionTemperature final : public TensionPart {
 public:
  explicit FrictionTemperature(const Values& values)
      : slope_1_K_(values["slope_1_K"]), reference_C_(values["reference_C"]) {}

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    return mu * (1 + slope_1_K_ * (covariates.sheath_C - reference_C_));
  }

 private:
  double slope_1_K_, reference_C_;
};

TensionKind friction_temperature() {
  return {"friction_temperature",
          {{{"slope_1_K", "1_K", {-0.02, 0.02}}}, {{"reference_C", "C", {-50, 150}}, 20}},
          {},
          make_part<FrictionTemperature>};
}

/// Stribeck and viscous friction: mu + (mu_s - mu) exp(-|v| / v_s) + kappa |v|, with the velocity
/// of the tendon in the sheath.
class FrictionVelocity final : public TensionPart {
 public:
  explicit FrictionVelocity(const Values& values)
      : static_coefficient_(values["static_coefficient"]),
        stribeck_velocity_m_s_(values["stribeck_velocity_mm_s"] * 1e-3),
        viscous_s_m_(values["viscous_s_m"]) {}

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    const double speed_m_s = std::abs(covariates.slide_m_s);
    return mu + (static_coefficient_ - mu) * std::exp(-speed_m_s / stribeck_velocity_m_s_) +
           viscous_s_m_ * speed_m_s;
  }

 private:
  double static_coefficient_, stribeck_velocity_m_s_, viscous_s_m_;
};

TensionKind friction_velocity() {
  return {"friction_velocity",
          {{{"static_coefficient", "", {0, 2}}},
           {{"stribeck_velocity_mm_s", "mm_s", {0.1, 1000}}},
           {{"viscous_s_m", "s_m", {-0.5, 10}}}},
          {},
          make_part<FrictionVelocity>};
}

/// Dahl's model: dz/dx = (1 - z s) / x_0, whose solution over one step in one direction is exact.
/// Reference: Dahl, A solid friction model, Aerospace Corporation TOR-158, 1968.
class Presliding final : public TensionPart {
 public:
  explicit Presliding(const Values& values) : length_m_(values["length_mm"] * 1e-3) {}

  [[nodiscard]] double friction_state(double /*state*/, double before,
                                      double slide_m) const override {
    const double end = slide_m < 0 ? -1 : 1;
    return end + (before - end) * std::exp(-std::abs(slide_m) / length_m_);
  }

 private:
  double length_m_;
};

TensionKind presliding() {
  return {"presliding", {{{"length_mm", "mm", {0.001, 20}}}}, {}, make_part<Presliding>};
}

/// mu * (T / T0)^-k with the tension at each place of the sheath.
class FrictionLoad final : public TensionPart {
 public:
  explicit FrictionLoad(const Values& values)
      : exponent_(values["exponent"]), reference_N_(values["reference_N"]) {}

  [[nodiscard]] double friction(double mu, const Covariates& /*covariates*/,
                                double tension_N) const override {
    return mu * std::pow(tension_N / reference_N_, -exponent_);
  }
  [[nodiscard]] bool along_sheath() const override { return true; }

 private:
  double exponent_, reference_N_;
};

TensionKind friction_load() {
  return {"friction_load",
          {{{"exponent", "", {-1, 1}}}, {{"reference_N", "N", {0.001, 1e6}}}},
          {},
          make_part<FrictionLoad>};
}

/// A force against the motion that no bend causes, as of a seal at the drive's end: T_in + F s.
class FrictionPreload final : public TensionPart {
 public:
  explicit FrictionPreload(const Values& values) : force_N_(values["force_N"]) {}

  [[nodiscard]] double input_tension_N(double tension_N, double friction_state,
                                       const Covariates& /*covariates*/) const override {
    return tension_N + force_N_ * friction_state;
  }

 private:
  double force_N_;
};

TensionKind friction_preload() {
  return {"friction_preload", {{{"force_N", "N", {-20, 20}}}}, {}, make_part<FrictionPreload>};
}

/// A rough or tight place of the sheath that the tendon passes:
/// mu * (1 + a exp(-((x - x_0) / w)^2 / 2)).
class FrictionPosition final : public TensionPart {
 public:
  explicit FrictionPosition(const Values& values)
      : change_(values["change"]),
        centre_m_(values["centre_mm"] * 1e-3),
        width_m_(values["width_mm"] * 1e-3) {}

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    const double from_centre = (covariates.position_m - centre_m_) / width_m_;
    return mu * (1 + change_ * std::exp(-from_centre * from_centre / 2));
  }

 private:
  double change_, centre_m_, width_m_;
};

TensionKind friction_position() {
  return {"friction_position",
          {{{"change", "", {-0.9, 5}}},
           {{"centre_mm", "mm", {-1000, 1000}}},
           {{"width_mm", "mm", {0.1, 1000}}}},
          {},
          make_part<FrictionPosition>};
}

/// A dead zone between spool and tendon. Its state is how much of it is taken up, 0 .. b; strictly
/// between, the drive holds only a part of the tension.
class Slack final : public TensionPart {
 public:
  explicit Slack(const Values& values)
      : dead_zone_m_(values["dead_zone_mm"] * 1e-3), held_(values["held_share"]) {}

  void advance(const Covariates& covariates) override {
    taken_up_m_ = std::clamp(taken_up_m_ + covariates.travel_m, 0.0, dead_zone_m_);
  }

  [[nodiscard]] double input_tension_N(double tension_N, double /*friction_state*/,
                                       const Covariates& /*covariates*/) const override {
    const bool loose = taken_up_m_ > 0 && taken_up_m_ < dead_zone_m_;
    return loose ? held_ * tension_N : tension_N;
  }

 private:
  double dead_zone_m_, held_;
  double taken_up_m_ = 0;
};

TensionKind slack() {
  return {"slack",
          {{{"dead_zone_mm", "mm", {0.001, 20}}}, {{"held_share", "", {0.01, 0.999}}}},
          {},
          make_part<Slack>};
}

/// Tendon and sheath as one spring between the drive and the sliding contact.
class Compliance final : public TensionPart {
 public:
  explicit Compliance(const Values& values) : stiffness_N_m_(values["stiffness_N_mm"] * 1e3) {}

  [[nodiscard]] double stiffness_N_m() const override { return stiffness_N_m_; }

 private:
  double stiffness_N_m_;
};

TensionKind compliance() {
  return {"compliance", {{{"stiffness_N_mm", "N_mm", {0.1, 1e5}}}}, {}, make_part<Compliance>};
}

/// The zero of the current sensor is off by a constant.
class CurrentOffset final : public TensionPart {
 public:
  explicit CurrentOffset(const Values& values) : offset_A_(values["offset_A"]) {}

  double reading(Sensor sensor, double value, const Covariates& /*covariates*/) override {
    return sensor == Sensor::motor_current ? value + offset_A_ : value;
  }

 private:
  double offset_A_;
};

TensionKind current_offset() {
  return {"current_offset", {{{"offset_A", "A", {-10, 10}}}}, {}, make_part<CurrentOffset>};
}

/// A torque constant that is wrong by a factor and weakens as the magnets warm with the winding:
/// K_t (1 + c - alpha (T_winding - T_ref)).
class TorqueGain final : public TensionPart {
 public:
  explicit TorqueGain(const Values& values)
      : error_(values["error"]),
        droop_1_K_(values["droop_1_K"]),
        reference_C_(values["reference_C"]) {}

  [[nodiscard]] double torque_constant_Nm_per_A(double constant_Nm_per_A,
                                                const Covariates& covariates) const override {
    const double gain = 1 + error_ - droop_1_K_ * (covariates.winding_C - reference_C_);
    return constant_Nm_per_A * std::max(kLeastGain, gain);
  }

 private:
  static constexpr double kLeastGain = 0.05;  // no magnet turns round

  double error_, droop_1_K_, reference_C_;
};

TensionKind torque_gain() {
  return {"torque_gain",
          {{{"error", "", {-0.3, 0.3}}, 0},
           {{"droop_1_K", "1_K", {-0.003, 0.003}}},
           {{"reference_C", "C", {-50, 150}}, 20}},
          {},
          make_part<TorqueGain>};
}

/// A gear that has one efficiency while it pulls and another while the load drives it back; both
/// are torque at the spool over torque of the motor times gear ratio.
class GearAsymmetry final : public TensionPart {
 public:
  explicit GearAsymmetry(const Values& values)
      : pulling_(values["pulling_efficiency"]), releasing_(values["releasing_efficiency"]) {}

  [[nodiscard]] double gear_efficiency(double /*efficiency*/,
                                       const Covariates& covariates) const override {
    return covariates.direction > 0 ? pulling_ : releasing_;
  }

 private:
  double pulling_, releasing_;
};

TensionKind gear_asymmetry() {
  return {"gear_asymmetry",
          {{{"pulling_efficiency", "", {0.1, 2}}}, {{"releasing_efficiency", "", {0.1, 2}}}},
          {},
          make_part<GearAsymmetry>};
}

/// Each pose of the plan bends the sheath by more or less than it is taken for: by the numbers
/// given, in turn, and by one that is drawn.
class BendAngle final : public TensionPart {
 public:
  explicit BendAngle(const Values& values)
      : errors_deg_(values.list("error_deg")), sd_deg_(values["sd_deg"]) {}

  void begin(const Setting& setting, std::uint64_t seed) override {
    Random random(seed, kPoseStream, setting.pose);
    const double error_deg =
        errors_deg_[setting.pose % errors_deg_.size()] + sd_deg_ * normal(random);
    error_rad_ = error_deg * std::numbers::pi / 180;
  }

  [[nodiscard]] double bend_angle_rad(double angle_rad,
                                      const Covariates& /*covariates*/) const override {
    return angle_rad + error_rad_;
  }

 private:
  std::vector<double> errors_deg_;
  double sd_deg_;
  double error_rad_ = 0;
};

TensionKind bend_angle() {
  return {"bend_angle",
          {{{"error_deg", "deg", {-90, 90}}, 0, true}, {{"sd_deg", "deg", {0, 60}}, 0}},
          {},
          make_part<BendAngle>};
}

/// Cogging: the motor also works against a sin(k theta + psi) with the angle of the rotor.
class TorqueRipple final : public TensionPart {
 public:
  explicit TorqueRipple(const Values& values)
      : torque_Nm_(values["amplitude_Nm"]),
        periods_per_turn_(values["periods_per_turn"]),
        phase_rad_(values["phase_deg"] * std::numbers::pi / 180) {}

  [[nodiscard]] double motor_torque_Nm(double torque_Nm, const Covariates& covariates,
                                       double rotor_per_travel_rad_m) const override {
    const double rotor_rad = covariates.position_m * rotor_per_travel_rad_m;
    return torque_Nm + torque_Nm_ * std::sin(periods_per_turn_ * rotor_rad + phase_rad_);
  }

 private:
  double torque_Nm_, periods_per_turn_, phase_rad_;
};

TensionKind torque_ripple() {
  return {"torque_ripple",
          {{{"amplitude_Nm", "Nm", {0, 10}}},
           {{"periods_per_turn", "", {1, 1000}}},
           {{"phase_deg", "deg", {-360, 360}}, 0}},
          {},
          make_part<TorqueRipple>};
}

Sensor sensor_of(const std::string& word) {
  if (word == "input_tension") {
    return Sensor::input_tension;
  }
  return word == "motor_current" ? Sensor::motor_current : Sensor::output_tension;
}

/// One sensor follows with a first-order lag, exact for readings that are linear within a step.
class FilterLag final : public TensionPart {
 public:
  explicit FilterLag(const Values& values)
      : sensor_(sensor_of(values.choice("sensor"))), lag_s_(values["time_constant_ms"] * 1e-3) {}

  double reading(Sensor sensor, double value, const Covariates& covariates) override {
    if (sensor != sensor_) {
      return value;
    }
    if (covariates.step_s <= 0) {
      state_ = last_ = value;
      return value;
    }
    const double behind = lag_s_ * (value - last_) / covariates.step_s;
    state_ = value - behind + (state_ - last_ + behind) * std::exp(-covariates.step_s / lag_s_);
    last_ = value;
    return state_;
  }

 private:
  Sensor sensor_;
  double lag_s_;
  double state_ = 0;
  double last_ = 0;
};

TensionKind filter_lag() {
  return {"filter_lag",
          {{{"time_constant_ms", "ms", {0.01, 1000}}}},
          {{"sensor", {"output_tension", "input_tension", "motor_current"}}},
          make_part<FilterLag>};
}

/// A drive that reads input tension and current more seldom than the recorder writes; between
/// its readings the recorder draws a line, or repeats the last one.
class Undersampling final : public TensionPart {
 public:
  explicit Undersampling(const Values& values)
      : rate_Hz_(values["rate_Hz"]), hold_(values.choice("between") == "hold") {}

  void record(Sensor sensor, std::vector<double>& readings, double sample_rate_Hz) const override {
    const bool of_drive = sensor == Sensor::input_tension || sensor == Sensor::motor_current;
    if (!of_drive || rate_Hz_ >= sample_rate_Hz) {
      return;
    }
    const std::vector<double> all = readings;
    const double step = sample_rate_Hz / rate_Hz_;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const double device = std::floor(static_cast<double>(i) / step + 1e-9);
      const double from = at(all, device * step);
      const double next = (device + 1) * step;
      const double to = next < static_cast<double>(all.size()) ? at(all, next) : from;
      const double share = static_cast<double>(i) / step - device;
      readings[i] = hold_ ? from : from + (to - from) * share;
    }
  }

 private:
  static double at(const std::vector<double>& values, double place) {
    const double last = static_cast<double>(values.size() - 1);
    const double inside = place < last ? place : last;
    const auto before = static_cast<std::size_t>(inside);
    const double share = inside - static_cast<double>(before);
    return share > 0 ? values[before] + (values[before + 1] - values[before]) * share
                     : values[before];
  }

  double rate_Hz_;
  bool hold_;
};

TensionKind undersampling() {
  return {"undersampling",
          {{{"rate_Hz", "Hz", {0.1, 1e5}}}},
          {{"between", {"line", "hold"}}},
          make_part<Undersampling>};
}

}  // namespace

std::span<const TensionKind> tension_kinds() {
  static const std::vector<TensionKind> kinds{
      friction_wear(), friction_temperature(), friction_velocity(), presliding(),
      friction_load(), friction_preload(),     friction_position(), slack(),
      compliance(),    current_offset(),       torque_gain(),       gear_asymmetry(),
      bend_angle(),    torque_ripple(),        filter_lag(),        undersampling(),
  };
  return kinds;
}

}  // namespace host_sim::synth
