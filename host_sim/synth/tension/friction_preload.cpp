#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// A force against the motion that no bend causes, as of a seal at the drive's end: T_in + F s.
class FrictionPreload final : public TensionPart {
 public:
  explicit FrictionPreload(const Values& values) : force_N_(values["force_N"]) {}

  [[nodiscard]] double input_tension_N(double tension_N, double friction_state,
                                       const Moment& /*moment*/) const override {
    return tension_N + force_N_ * friction_state;
  }

 private:
  double force_N_;
};

}  // namespace

TensionKind friction_preload() {
  return {"friction_preload", {{{"force_N", "N", {-20, 20}}}}, {}, make_part<FrictionPreload>};
}

}  // namespace host_sim::synth
