#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The motor also speeds up and slows down its own rotor.
class RotorInertia final : public TensionPart {
 public:
  explicit RotorInertia(const Values& values) : inertia_kg_m2_(values["inertia_g_cm2"] * 1e-7) {}

  [[nodiscard]] double motor_torque_Nm(double torque_Nm, const Moment& moment,
                                       double rotor_per_travel_rad_m) const override {
    return torque_Nm + inertia_kg_m2_ * moment.acceleration_m_s2 * rotor_per_travel_rad_m;
  }

 private:
  double inertia_kg_m2_;
};

}  // namespace

TensionKind rotor_inertia() {
  return {"rotor_inertia", {{{"inertia_g_cm2", "g_cm2", {0, 1e7}}}}, {}, make_part<RotorInertia>};
}

}  // namespace host_sim::synth
