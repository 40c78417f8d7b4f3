#include <algorithm>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// A torque constant that is wrong by a factor and weakens as the magnets warm with the winding:
/// K_t (1 + c - alpha (T_winding - T_ref)).
class TorqueGain final : public TensionPart {
 public:
  explicit TorqueGain(const Values& values)
      : error_(values["error"]),
        droop_1_K_(values["droop_1_K"]),
        reference_C_(values["reference_C"]) {}

  [[nodiscard]] double torque_constant_Nm_per_A(double constant_Nm_per_A,
                                                const Moment& moment) const override {
    const double gain = 1 + error_ - droop_1_K_ * (moment.winding_C - reference_C_);
    return constant_Nm_per_A * std::max(kLeastGain, gain);
  }

 private:
  static constexpr double kLeastGain = 0.05;  // no magnet turns round

  double error_, droop_1_K_, reference_C_;
};

}  // namespace

TensionKind torque_gain() {
  return {"torque_gain",
          {{{"error", "", {-0.3, 0.3}}, 0},
           {{"droop_1_K", "1_K", {-0.003, 0.003}}},
           {{"reference_C", "C", {-50, 150}}, 20}},
          {},
          make_part<TorqueGain>};
}

}  // namespace host_sim::synth
