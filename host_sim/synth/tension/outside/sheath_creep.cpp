#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The sheath creeps under the tendon in the course of a session, and the tension that the drive
/// needs drifts by a share in both directions, with a time constant.
class SheathCreep final : public TensionPart {
 public:
  explicit SheathCreep(const Values& values)
      : share_(values["share"]), time_constant_s_(values["time_constant_s"]) {}

  [[nodiscard]] double input_tension_N(double tension_N, double /*friction_state*/,
                                       const Moment& moment) const override {
    return tension_N * (1 + share_ * -std::expm1(-moment.time_s / time_constant_s_));
  }

 private:
  double share_, time_constant_s_;
};

}  // namespace

TensionKind sheath_creep() {
  return {"sheath_creep",
          {{{"share", "", {-0.5, 0.5}}}, {{"time_constant_s", "s", {0.1, 1e5}}}},
          {},
          make_part<SheathCreep>};
}

}  // namespace host_sim::synth
