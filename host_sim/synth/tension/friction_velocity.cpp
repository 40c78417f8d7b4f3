#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Stribeck and viscous friction: mu + (mu_s - mu) exp(-|v| / v_s) + kappa |v|, with the velocity
/// of the tendon in the sheath.
class FrictionVelocity final : public TensionPart {
 public:
  explicit FrictionVelocity(const Values& values)
      : static_coefficient_(values["static_coefficient"]),
        stribeck_velocity_m_s_(values["stribeck_velocity_mm_s"] * 1e-3),
        viscous_s_m_(values["viscous_s_m"]) {}

  [[nodiscard]] double friction(double mu, const Moment& moment,
                                double /*tension_N*/) const override {
    const double speed_m_s = std::abs(moment.slide_m_s);
    return mu + (static_coefficient_ - mu) * std::exp(-speed_m_s / stribeck_velocity_m_s_) +
           viscous_s_m_ * speed_m_s;
  }

 private:
  double static_coefficient_, stribeck_velocity_m_s_, viscous_s_m_;
};

}  // namespace

TensionKind friction_velocity() {
  return {"friction_velocity",
          {{{"static_coefficient", "", {0, 2}}},
           {{"stribeck_velocity_mm_s", "mm_s", {0.1, 1000}}},
           {{"viscous_s_m", "s_m", {-0.5, 10}}}},
          {},
          make_part<FrictionVelocity>};
}

}  // namespace host_sim::synth
