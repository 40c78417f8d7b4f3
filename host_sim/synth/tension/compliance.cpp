#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Tendon and sheath as one spring between the drive and the sliding contact.
class Compliance final : public TensionPart {
 public:
  explicit Compliance(const Values& values) : stiffness_N_m_(values["stiffness_N_mm"] * 1e3) {}

  [[nodiscard]] double stiffness_N_m() const override { return stiffness_N_m_; }

 private:
  double stiffness_N_m_;
};

}  // namespace

TensionKind compliance() {
  return {"compliance", {{{"stiffness_N_mm", "N_mm", {0.1, 1e5}}}}, {}, make_part<Compliance>};
}

}  // namespace host_sim::synth
