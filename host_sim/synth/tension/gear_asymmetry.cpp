#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// A gear that has one efficiency while it pulls and another while the load drives it back; both
/// are torque at the spool over torque of the motor times gear ratio.
class GearAsymmetry final : public TensionPart {
 public:
  explicit GearAsymmetry(const Values& values)
      : pulling_(values["pulling_efficiency"]), releasing_(values["releasing_efficiency"]) {}

  [[nodiscard]] double gear_efficiency(double /*efficiency*/, const Moment& moment) const override {
    return moment.direction > 0 ? pulling_ : releasing_;
  }

 private:
  double pulling_, releasing_;
};

}  // namespace

TensionKind gear_asymmetry() {
  return {"gear_asymmetry",
          {{{"pulling_efficiency", "", {0.1, 2}}}, {{"releasing_efficiency", "", {0.1, 2}}}},
          {},
          make_part<GearAsymmetry>};
}

}  // namespace host_sim::synth
