#include <algorithm>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The sheath straightens, or curls, as the tendon pulls harder.
class TensionDependentBend final : public TensionPart {
 public:
  explicit TensionDependentBend(const Values& values)
      : share_1_N_(values["share_1_N"]), reference_N_(values["reference_N"]) {}

  [[nodiscard]] double bend_angle_rad(double angle_rad, const Moment& moment) const override {
    return angle_rad * std::max(0.0, 1 + share_1_N_ * (moment.output_tension_N - reference_N_));
  }

 private:
  double share_1_N_, reference_N_;
};

}  // namespace

TensionKind tension_dependent_bend() {
  return {"tension_dependent_bend",
          {{{"share_1_N", "1_N", {-0.2, 0.2}}}, {{"reference_N", "N", {0, 1000}}}},
          {},
          make_part<TensionDependentBend>};
}

}  // namespace host_sim::synth
