#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The load cell at the input feels the cable that sways with the pose.
class LoadCellCrossTalk final : public TensionPart {
 public:
  explicit LoadCellCrossTalk(const Values& values)
      : newtons_per_rad_s_(values["sensitivity_N_s_rad"]) {}

  double reading(Sensor sensor, double value, const Moment& moment) override {
    return sensor == Sensor::input_tension ? value + newtons_per_rad_s_ * moment.bend_rate_rad_s
                                           : value;
  }

 private:
  double newtons_per_rad_s_;
};

}  // namespace

TensionKind load_cell_cross_talk() {
  return {"load_cell_cross_talk",
          {{{"sensitivity_N_s_rad", "N_s_rad", {-100, 100}}}},
          {},
          make_part<LoadCellCrossTalk>};
}

}  // namespace host_sim::synth
