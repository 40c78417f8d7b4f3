#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// mu * (1 + k (T_sheath - T_ref)).
class FrictionTemperature final : public TensionPart {
 public:
  explicit FrictionTemperature(const Values& values)
      : slope_1_K_(values["slope_1_K"]), reference_C_(values["reference_C"]) {}

  [[nodiscard]] double friction(double mu, const Moment& moment,
                                double /*tension_N*/) const override {
    return mu * (1 + slope_1_K_ * (moment.sheath_C - reference_C_));
  }

 private:
  double slope_1_K_, reference_C_;
};

}  // namespace

TensionKind friction_temperature() {
  return {"friction_temperature",
          {{{"slope_1_K", "1_K", {-0.02, 0.02}}}, {{"reference_C", "C", {-50, 150}}, 20}},
          {},
          make_part<FrictionTemperature>};
}

}  // namespace host_sim::synth
