#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/tension/departures.hpp"
#include "host_sim/synth/tension/sensors.hpp"

namespace host_sim::synth {
namespace {

/// The load cell at the input remembers its way: a share of what it reads is the mean of plays of
/// equally spaced widths. Reference: Krejci and Kuhnen, Inverse control of systems with hysteresis
/// and creep, IEE Proceedings, Control Theory and Applications 148, 2001.
class LoadCellHysteresis final : public TensionPart {
 public:
  explicit LoadCellHysteresis(const Values& values)
      : share_(values["share"]), widest_N_(values["widest_N"]) {}

  double reading(Sensor sensor, double value, const Covariates& /*covariates*/) override {
    if (sensor != Sensor::input_tension) {
      return value;
    }
    double mean_N = 0;
    for (std::size_t i = 0; i < plays_N_.size(); ++i) {
      const auto number = static_cast<double>(i + 1);
      const double half_N = widest_N_ * number / static_cast<double>(2 * plays_N_.size());
      plays_N_[i] = begun_ ? std::clamp(plays_N_[i], value - half_N, value + half_N) : value;
      mean_N += plays_N_[i] / static_cast<double>(plays_N_.size());
    }
    begun_ = true;
    return value + share_ * (mean_N - value);
  }

 private:
  double share_, widest_N_;
  std::array<double, 8> plays_N_{};
  bool begun_ = false;
};

TensionKind load_cell_hysteresis() {
  return {"load_cell_hysteresis",
          {{{"share", "", {0, 1}}}, {{"widest_N", "N", {0, 1000}}}},
          {},
          make_part<LoadCellHysteresis>};
}

/// A velocity in coarse steps that at standstill flickers about zero, as often the wrong way as the
/// right one.
class VelocitySteps final : public TensionPart {
 public:
  explicit VelocitySteps(const Values& values) : step_m_s_(values["step_mm_s"] * 1e-3) {}

  void begin(const Setting& setting, std::uint64_t seed) override {
    random_.emplace(seed, kVelocityStepStream, setting.number);
  }

  void record(Sensor sensor, std::vector<double>& readings,
              double /*sample_rate_Hz*/) const override {
    if (sensor != Sensor::velocity) {
      return;
    }
    Random random = *random_;
    for (double& value : readings) {
      value = quantised(value, step_m_s_);
      if (value == 0) {
        value = random.uniform() < 0.5 ? step_m_s_ : -step_m_s_;
      }
    }
  }

 private:
  double step_m_s_;
  std::optional<Random> random_;
};

TensionKind velocity_steps() {
  return {"velocity_steps", {{{"step_mm_s", "mm_s", {0.001, 1e4}}}}, {}, make_part<VelocitySteps>};
}

/// The gain of the output load cell drifts in the course of a session, in each at another rate.
class GainDrift final : public TensionPart {
 public:
  explicit GainDrift(const Values& values) : log_per_min_sd_(values["log_per_min_sd"]) {}

  void begin(const Setting& setting, std::uint64_t seed) override {
    Random random(seed, kGainDriftStream, setting.number);
    log_per_s_ = log_per_min_sd_ * normal(random) / 60;
  }

  double reading(Sensor sensor, double value, const Covariates& covariates) override {
    return sensor == Sensor::output_tension ? value * std::exp(log_per_s_ * covariates.time_s)
                                            : value;
  }

 private:
  double log_per_min_sd_;
  double log_per_s_ = 0;
};

TensionKind gain_drift() {
  return {"gain_drift", {{{"log_per_min_sd", "", {0, 10}}}}, {}, make_part<GainDrift>};
}

/// What holds the sensors at the drive rings: x'' = w^2 (T - x) - 2 zeta w x'.
class Resonance final : public TensionPart {
 public:
  explicit Resonance(const Values& values)
      : rate_rad_s_(2 * std::numbers::pi * values["frequency_Hz"]), damping_(values["damping"]) {}

  double reading(Sensor sensor, double value, const Covariates& covariates) override {
    if (sensor == Sensor::output_tension) {
      return value;
    }
    Ringing& state = states_[sensor == Sensor::input_tension ? 0 : 1];
    if (covariates.step_s <= 0) {
      state = {value, 0};
      return value;
    }
    const double pull =
        rate_rad_s_ * (rate_rad_s_ * (value - state.place) - 2 * damping_ * state.speed);
    state.speed += pull * covariates.step_s;
    state.place += state.speed * covariates.step_s;
    return state.place;
  }

 private:
  struct Ringing {
    double place = 0, speed = 0;
  };

  double rate_rad_s_, damping_;
  std::array<Ringing, 2> states_{};
};

TensionKind resonance() {
  return {"resonance",
          {{{"frequency_Hz", "Hz", {0.1, 200}}}, {{"damping", "", {0.001, 1}}}},
          {},
          make_part<Resonance>};
}

/// The output load cell reads less and less more: L tanh(T / L).
class SoftSaturation final : public TensionPart {
 public:
  explicit SoftSaturation(const Values& values) : limit_N_(values["limit_N"]) {}

  double reading(Sensor sensor, double value, const Covariates& /*covariates*/) override {
    return sensor == Sensor::output_tension ? limit_N_ * std::tanh(value / limit_N_) : value;
  }

 private:
  double limit_N_;
};

TensionKind soft_saturation() {
  return {"soft_saturation", {{{"limit_N", "N", {1, 1e5}}}}, {}, make_part<SoftSaturation>};
}

}  // namespace

std::span<const TensionKind> outside_sensor_kinds() {
  static const std::vector<TensionKind> kinds{gain_drift(), load_cell_hysteresis(), resonance(),
                                              soft_saturation(), velocity_steps()};
  return kinds;
}

}  // namespace host_sim::synth
