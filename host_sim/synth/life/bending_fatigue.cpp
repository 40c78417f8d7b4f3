#include "host_sim/synth/life/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The wire also bends round the sheath: its bending stress c E d / D, from 0 and back once a
/// cycle, acts on the metal of the cable as a tension.
class BendingFatigue final : public LifePart {
 public:
  explicit BendingFatigue(const Values& values)
      : modulus_N_mm2_(values["modulus_GPa"] * 1e3),
        area_mm2_(values["metal_area_mm2"]),
        share_(values["share"]) {}

  [[nodiscard]] reference::MeanAmplitude input_N(reference::MeanAmplitude input,
                                                 const LifeLoad& load) const override {
    const double bending_N = share_ * modulus_N_mm2_ * area_mm2_ * load.wire_to_bend_ratio;
    return {input.mean_N + bending_N / 2, input.amplitude_N + bending_N / 2};
  }

 private:
  double modulus_N_mm2_, area_mm2_, share_;
};

}  // namespace

LifeKind bending_fatigue() {
  return {"bending_fatigue",
          {{{"modulus_GPa", "GPa", {1, 1000}}, 190},
           {{"metal_area_mm2", "mm2", {1e-4, 100}}},
           {{"share", "", {0, 1}}}},
          {},
          make_life_part<BendingFatigue>};
}

}  // namespace host_sim::synth
