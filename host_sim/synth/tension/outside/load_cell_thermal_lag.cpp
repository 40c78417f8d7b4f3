#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

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

  void advance(const Moment& moment) override {
    cell_C_ += (moment.ambient_C - cell_C_) * -std::expm1(-moment.step_s / time_constant_s_);
  }

  double reading(Sensor sensor, double value, const Moment& /*moment*/) override {
    return sensor == Sensor::input_tension ? value + drift_N_K_ * (cell_C_ - reference_C_) : value;
  }

 private:
  double drift_N_K_, time_constant_s_, reference_C_;
  double cell_C_ = 0;
};

}  // namespace

TensionKind load_cell_thermal_lag() {
  return {"load_cell_thermal_lag",
          {{{"drift_N_K", "N_K", {-5, 5}}},
           {{"time_constant_s", "s", {0.1, 1e5}}},
           {{"reference_C", "C", {-50, 150}}, 20}},
          {},
          make_part<LoadCellThermalLag>};
}

}  // namespace host_sim::synth
