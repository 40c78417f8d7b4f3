#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Dahl's model: dz/dx = (1 - z s) / x_0, whose solution over one step in one direction is exact.
/// Reference: Dahl, A solid friction model, Aerospace Corporation TOR-158, 1968.
class Presliding final : public TensionPart {
 public:
  explicit Presliding(const Values& values) : length_m_(values["length_mm"] * 1e-3) {}

  [[nodiscard]] double friction_state(double /*state*/, double before,
                                      double slide_m) const override {
    const double end = slide_m < 0 ? -1 : 1;
    return end + (before - end) * std::exp(-std::abs(slide_m) / length_m_);
  }

 private:
  double length_m_;
};

}  // namespace

TensionKind presliding() {
  return {"presliding", {{{"length_mm", "mm", {0.001, 20}}}}, {}, make_part<Presliding>};
}

}  // namespace host_sim::synth
