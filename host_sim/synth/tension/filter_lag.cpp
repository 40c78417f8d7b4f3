#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

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
      : sensor_(sensor_of(values.word("sensor"))), lag_s_(values["time_constant_ms"] * 1e-3) {}

  double reading(Sensor sensor, double value, const Moment& moment) override {
    if (sensor != sensor_) {
      return value;
    }
    if (moment.step_s <= 0) {
      state_ = last_ = value;
      return value;
    }
    const double behind = lag_s_ * (value - last_) / moment.step_s;
    state_ = value - behind + (state_ - last_ + behind) * std::exp(-moment.step_s / lag_s_);
    last_ = value;
    return state_;
  }

 private:
  Sensor sensor_;
  double lag_s_;
  double state_ = 0;
  double last_ = 0;
};

}  // namespace

TensionKind filter_lag() {
  return {"filter_lag",
          {{{"time_constant_ms", "ms", {0.01, 1000}}}},
          {{"sensor", {"output_tension", "input_tension", "motor_current"}}},
          make_part<FilterLag>};
}

}  // namespace host_sim::synth
