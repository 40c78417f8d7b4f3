#include <algorithm>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// A dead zone between spool and tendon. Its state is how much of it is taken up, 0 .. b; strictly
/// between, the drive holds only a part of the tension.
class Slack final : public TensionPart {
 public:
  explicit Slack(const Values& values)
      : dead_zone_m_(values["dead_zone_mm"] * 1e-3), held_(values["held_share"]) {}

  void advance(const Moment& moment) override {
    taken_up_m_ = std::clamp(taken_up_m_ + moment.travel_m, 0.0, dead_zone_m_);
  }

  [[nodiscard]] double input_tension_N(double tension_N, double /*friction_state*/,
                                       const Moment& /*moment*/) const override {
    const bool loose = taken_up_m_ > 0 && taken_up_m_ < dead_zone_m_;
    return loose ? held_ * tension_N : tension_N;
  }

 private:
  double dead_zone_m_, held_;
  double taken_up_m_ = 0;
};

}  // namespace

TensionKind slack() {
  return {"slack",
          {{{"dead_zone_mm", "mm", {0.001, 20}}}, {{"held_share", "", {0.01, 0.999}}}},
          {},
          make_part<Slack>};
}

}  // namespace host_sim::synth
