#include <cmath>
#include <numbers>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Friction follows the humidity of the room, which has a cycle by the wall clock.
class HumidityCycle final : public TensionPart {
 public:
  explicit HumidityCycle(const Values& values)
      : share_(values["share"]),
        period_h_(values["period_h"]),
        phase_rad_(values["phase_deg"] * std::numbers::pi / 180) {}

  [[nodiscard]] double friction(double mu, const Moment& moment,
                                double /*tension_N*/) const override {
    const double turn_rad = 2 * std::numbers::pi * moment.wall_clock_h / period_h_;
    return mu * (1 + share_ * std::sin(turn_rad + phase_rad_));
  }

 private:
  double share_, period_h_, phase_rad_;
};

}  // namespace

TensionKind humidity_cycle() {
  return {"humidity_cycle",
          {{{"share", "", {-0.9, 0.9}}},
           {{"period_h", "h", {0.01, 1e4}}, 24},
           {{"phase_deg", "deg", {-360, 360}}, 0}},
          {},
          make_part<HumidityCycle>};
}

}  // namespace host_sim::synth
