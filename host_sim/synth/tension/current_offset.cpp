#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The zero of the current sensor is off by a constant.
class CurrentOffset final : public TensionPart {
 public:
  explicit CurrentOffset(const Values& values) : offset_A_(values["offset_A"]) {}

  double reading(Sensor sensor, double value, const Moment& /*moment*/) override {
    return sensor == Sensor::motor_current ? value + offset_A_ : value;
  }

 private:
  double offset_A_;
};

}  // namespace

TensionKind current_offset() {
  return {"current_offset", {{{"offset_A", "A", {-10, 10}}}}, {}, make_part<CurrentOffset>};
}

}  // namespace host_sim::synth
