#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/tension/departures.hpp"

namespace host_sim::synth {
namespace {

/// The sheath creeps under the tendon in the course of a session, and the tension that the drive
/// needs drifts by a share in both directions, with a time constant.
class SheathCreep final : public TensionPart {
 public:
  explicit SheathCreep(const Values& values)
      : share_(values["share"]), time_constant_s_(values["time_constant_s"]) {}

  [[nodiscard]] double input_tension_N(double tension_N, double /*friction_state*/,
                                       const Covariates& covariates) const override {
    return tension_N * (1 + share_ * -std::expm1(-covariates.time_s / time_constant_s_));
  }

 private:
  double share_, time_constant_s_;
};

TensionKind sheath_creep() {
  return {"sheath_creep",
          {{{"share", "", {-0.5, 0.5}}}, {{"time_constant_s", "s", {0.1, 1e5}}}},
          {},
          make_part<SheathCreep>};
}

/// Bursts of stick-slip at random times: within one, friction rises by a share and lets go, as a
/// saw tooth. Bursts begin at a constant rate and do not overlap.
class StickSlip final : public TensionPart {
 public:
  explicit StickSlip(const Values& values)
      : share_(values["share"]),
        mean_wait_s_(60 / values["bursts_per_min"]),
        burst_s_(values["burst_s"]),
        frequency_Hz_(values["frequency_Hz"]) {}

  void begin(const Setting& setting, std::uint64_t seed) override {
    random_.emplace(seed, kStickSlipStream, setting.number);
    next_s_ = mean_wait_s_ * exponential(*random_);
  }

  void advance(const Covariates& covariates) override {
    while (covariates.time_s >= next_s_ + burst_s_) {
      next_s_ += burst_s_ + mean_wait_s_ * exponential(*random_);
    }
  }

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    if (covariates.time_s < next_s_) {
      return mu;
    }
    const double teeth = (covariates.time_s - next_s_) * frequency_Hz_;
    return mu * (1 + share_ * (teeth - std::floor(teeth)));
  }

 private:
  double share_, mean_wait_s_, burst_s_, frequency_Hz_;
  std::optional<Random> random_;
  double next_s_ = 0;
};

TensionKind stick_slip() {
  return {"stick_slip",
          {{{"share", "", {0, 5}}},
           {{"bursts_per_min", "", {0.01, 600}}},
           {{"burst_s", "s", {0.001, 1000}}},
           {{"frequency_Hz", "Hz", {0.1, 1000}}}},
          {},
          make_part<StickSlip>};
}

/// The load cell at the input feels the cable that sways with the pose.
class LoadCellCrossTalk final : public TensionPart {
 public:
  explicit LoadCellCrossTalk(const Values& values)
      : newtons_per_rad_s_(values["sensitivity_N_s_rad"]) {}

  double reading(Sensor sensor, double value, const Covariates& covariates) override {
    return sensor == Sensor::input_tension ? value + newtons_per_rad_s_ * covariates.bend_rate_rad_s
                                           : value;
  }

 private:
  double newtons_per_rad_s_;
};

TensionKind load_cell_cross_talk() {
  return {"load_cell_cross_talk",
          {{{"sensitivity_N_s_rad", "N_s_rad", {-100, 100}}}},
          {},
          make_part<LoadCellCrossTalk>};
}

/// Friction follows the humidity of the room, which has a cycle by the wall clock.
class HumidityCycle final : public TensionPart {
 public:
  explicit HumidityCycle(const Values& values)
      : share_(values["share"]),
        period_h_(values["period_h"]),
        phase_rad_(values["phase_deg"] * std::numbers::pi / 180) {}

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    const double turn_rad = 2 * std::numbers::pi * covariates.wall_clock_h / period_h_;
    return mu * (1 + share_ * std::sin(turn_rad + phase_rad_));
  }

 private:
  double share_, period_h_, phase_rad_;
};

TensionKind humidity_cycle() {
  return {"humidity_cycle",
          {{{"share", "", {-0.9, 0.9}}},
           {{"period_h", "h", {0.01, 1e4}}, 24},
           {{"phase_deg", "deg", {-360, 360}}, 0}},
          {},
          make_part<HumidityCycle>};
}

/// The sheath straightens, or curls, as the tendon pulls harder.
class TensionDependentBend final : public TensionPart {
 public:
  explicit TensionDependentBend(const Values& values)
      : share_1_N_(values["share_1_N"]), reference_N_(values["reference_N"]) {}

  [[nodiscard]] double bend_angle_rad(double angle_rad,
                                      const Covariates& covariates) const override {
    return angle_rad * std::max(0.0, 1 + share_1_N_ * (covariates.output_tension_N - reference_N_));
  }

 private:
  double share_1_N_, reference_N_;
};

TensionKind tension_dependent_bend() {
  return {"tension_dependent_bend",
          {{{"share_1_N", "1_N", {-0.2, 0.2}}}, {{"reference_N", "N", {0, 1000}}}},
          {},
          make_part<TensionDependentBend>};
}

/// The zero of the load cell at the input drifts with its own temperature, which follows the
/// surroundings of the sheath with a lag; it is at the room's when a session begins.
class LoadCellThermalLag final : public TensionPart {
 public:
  explicit LoadCellThermalLag(const Values& values)
      : drift_N_K_(values["drift_N_K"]),
        time_constant_s_(values["time_constant_s"]),
        reference_C_(values["reference_C"]) {}

  void begin(const Setting& /*setting*/, std::uint64_t /*seed*/) override {
    cell_C_ = reference_C_;
  }

  void advance(const Covariates& covariates) override {
    cell_C_ +=
        (covariates.ambient_C - cell_C_) * -std::expm1(-covariates.step_s / time_constant_s_);
  }

  double reading(Sensor sensor, double value, const Covariates& /*covariates*/) override {
    return sensor == Sensor::input_tension ? value + drift_N_K_ * (cell_C_ - reference_C_) : value;
  }

 private:
  double drift_N_K_, time_constant_s_, reference_C_;
  double cell_C_ = 0;
};

TensionKind load_cell_thermal_lag() {
  return {"load_cell_thermal_lag",
          {{{"drift_N_K", "N_K", {-5, 5}}},
           {{"time_constant_s", "s", {0.1, 1e5}}},
           {{"reference_C", "C", {-50, 150}}, 20}},
          {},
          make_part<LoadCellThermalLag>};
}

/// The motor also speeds up and slows down its own rotor.
class RotorInertia final : public TensionPart {
 public:
  explicit RotorInertia(const Values& values) : inertia_kg_m2_(values["inertia_g_cm2"] * 1e-7) {}

  [[nodiscard]] double motor_torque_Nm(double torque_Nm, const Covariates& covariates,
                                       double rotor_per_travel_rad_m) const override {
    return torque_Nm + inertia_kg_m2_ * covariates.acceleration_m_s2 * rotor_per_travel_rad_m;
  }

 private:
  double inertia_kg_m2_;
};

TensionKind rotor_inertia() {
  return {"rotor_inertia", {{{"inertia_g_cm2", "g_cm2", {0, 1e7}}}}, {}, make_part<RotorInertia>};
}

/// Friction is larger, or smaller, while the tendon speeds up than while it slows down.
class FrictionAcceleration final : public TensionPart {
 public:
  explicit FrictionAcceleration(const Values& values) : share_s2_m_(values["share_s2_m"]) {}

  [[nodiscard]] double friction(double mu, const Covariates& covariates,
                                double /*tension_N*/) const override {
    return mu * (1 + share_s2_m_ * covariates.acceleration_m_s2 * covariates.direction);
  }

 private:
  double share_s2_m_;
};

TensionKind friction_acceleration() {
  return {"friction_acceleration",
          {{{"share_s2_m", "s2_m", {-100, 100}}}},
          {},
          make_part<FrictionAcceleration>};
}

/// Friction of rest: a bond between tendon and sheath that forms in time and breaks by travel,
/// dc/dt = (1 - c) / tau - c |v| / L, and mu (1 + a c).
class DwellFriction final : public TensionPart {
 public:
  explicit DwellFriction(const Values& values)
      : share_(values["share"]),
        time_s_(values["time_constant_s"]),
        length_m_(values["length_mm"] * 1e-3) {}

  void advance(const Covariates& covariates) override {
    const double rate_1_s = 1 / time_s_ + std::abs(covariates.velocity_m_s) / length_m_;
    const double settled = 1 / (time_s_ * rate_1_s);
    bond_ = settled + (bond_ - settled) * std::exp(-rate_1_s * covariates.step_s);
  }

  [[nodiscard]] double friction(double mu, const Covariates& /*covariates*/,
                                double /*tension_N*/) const override {
    return mu * (1 + share_ * bond_);
  }

 private:
  double share_, time_s_, length_m_;
  double bond_ = 1;
};

TensionKind dwell_friction() {
  return {"dwell_friction",
          {{{"share", "", {0, 10}}},
           {{"time_constant_s", "s", {0.001, 1e4}}},
           {{"length_mm", "mm", {0.001, 1000}}}},
          {},
          make_part<DwellFriction>};
}

}  // namespace

std::span<const TensionKind> outside_tension_kinds() {
  static const std::vector<TensionKind> kinds = [] {
    std::vector<TensionKind> all{
        sheath_creep(),           stick_slip(),
        load_cell_cross_talk(),   humidity_cycle(),
        tension_dependent_bend(), load_cell_thermal_lag(),
        rotor_inertia(),          friction_acceleration(),
        dwell_friction(),
    };
    const auto of_sensors = outside_sensor_kinds();
    all.insert(all.end(), of_sensors.begin(), of_sensors.end());
    return all;
  }();
  return kinds;
}

}  // namespace host_sim::synth
