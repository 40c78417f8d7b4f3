#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// A rough or tight place of the sheath that the tendon passes:
/// mu * (1 + a exp(-((x - x_0) / w)^2 / 2)).
class FrictionPosition final : public TensionPart {
 public:
  explicit FrictionPosition(const Values& values)
      : change_(values["change"]),
        centre_m_(values["centre_mm"] * 1e-3),
        width_m_(values["width_mm"] * 1e-3) {}

  [[nodiscard]] double friction(double mu, const Moment& moment,
                                double /*tension_N*/) const override {
    const double from_centre = (moment.position_m - centre_m_) / width_m_;
    return mu * (1 + change_ * std::exp(-from_centre * from_centre / 2));
  }

 private:
  double change_, centre_m_, width_m_;
};

}  // namespace

TensionKind friction_position() {
  return {"friction_position",
          {{{"change", "", {-0.9, 5}}},
           {{"centre_mm", "mm", {-1000, 1000}}},
           {{"width_mm", "mm", {0.1, 1000}}}},
          {},
          make_part<FrictionPosition>};
}

}  // namespace host_sim::synth
