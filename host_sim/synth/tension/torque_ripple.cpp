#include <cmath>
#include <numbers>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Cogging: the motor also works against a sin(k theta + psi) with the angle of the rotor.
class TorqueRipple final : public TensionPart {
 public:
  explicit TorqueRipple(const Values& values)
      : torque_Nm_(values["amplitude_Nm"]),
        periods_per_turn_(values["periods_per_turn"]),
        phase_rad_(values["phase_deg"] * std::numbers::pi / 180) {}

  [[nodiscard]] double motor_torque_Nm(double torque_Nm, const Moment& moment,
                                       double rotor_per_travel_rad_m) const override {
    const double rotor_rad = moment.position_m * rotor_per_travel_rad_m;
    return torque_Nm + torque_Nm_ * std::sin(periods_per_turn_ * rotor_rad + phase_rad_);
  }

 private:
  double torque_Nm_, periods_per_turn_, phase_rad_;
};

}  // namespace

TensionKind torque_ripple() {
  return {"torque_ripple",
          {{{"amplitude_Nm", "Nm", {0, 10}}},
           {{"periods_per_turn", "", {1, 1000}}},
           {{"phase_deg", "deg", {-360, 360}}, 0}},
          {},
          make_part<TorqueRipple>};
}

}  // namespace host_sim::synth
