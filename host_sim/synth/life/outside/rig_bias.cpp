#include "host_sim/synth/life/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Every second rig loads its specimens by more than it says.
class RigBias final : public LifePart {
 public:
  explicit RigBias(const Values& values) : share_(values["share"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t /*seed*/) override {
    factor_ = place.rig % 2 == 1 ? 1 + share_ : 1;
  }

  [[nodiscard]] reference::MeanAmplitude output_N(reference::MeanAmplitude output) const override {
    return {output.mean_N * factor_, output.amplitude_N * factor_};
  }

 private:
  double share_;
  double factor_ = 1;
};

}  // namespace

LifeKind rig_bias() {
  return {"rig_bias", {{{"share", "", {-0.5, 0.5}}}}, {}, make_life_part<RigBias>};
}

}  // namespace host_sim::synth
