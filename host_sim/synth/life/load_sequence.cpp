#include "host_sim/synth/life/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Damage curve of Manson and Halford: a share f of the life N_1 counts as the share
/// f^((N_1 / N_2)^q) of the life N_2. Reference: Manson and Halford, Practical implementation of
/// the double linear damage rule and damage curve approach, Int. J. Fracture 17, 1981.
class LoadSequence final : public LifePart {
 public:
  explicit LoadSequence(const Values& values) : exponent_(values["exponent"]) {}

  [[nodiscard]] double sequence_exponent() const override { return exponent_; }

 private:
  double exponent_;
};

}  // namespace

LifeKind load_sequence() {
  return {"load_sequence", {{{"exponent", "", {-1, 1}}, 0.4}}, {}, make_life_part<LoadSequence>};
}

}  // namespace host_sim::synth
