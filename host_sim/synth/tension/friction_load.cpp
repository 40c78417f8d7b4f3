#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// mu * (T / T0)^-k with the tension at each place of the sheath.
class FrictionLoad final : public TensionPart {
 public:
  explicit FrictionLoad(const Values& values)
      : exponent_(values["exponent"]), reference_N_(values["reference_N"]) {}

  [[nodiscard]] double friction(double mu, const Moment& /*moment*/,
                                double tension_N) const override {
    return mu * std::pow(tension_N / reference_N_, -exponent_);
  }
  [[nodiscard]] bool along_sheath() const override { return true; }

 private:
  double exponent_, reference_N_;
};

}  // namespace

TensionKind friction_load() {
  return {"friction_load",
          {{{"exponent", "", {-1, 1}}}, {{"reference_N", "N", {0.1, 1000}}}},
          {},
          make_part<FrictionLoad>};
}

}  // namespace host_sim::synth
