#include "host_sim/synth/life/catalogue.hpp"

#include <vector>

#include "host_sim/synth/life/kinds.hpp"

namespace host_sim::synth {

std::span<const LifeKind> life_kinds() {
  static const std::vector<LifeKind> kinds{mean_stress(),   bending_fatigue(), endurance_limit(),
                                           load_sequence(), second_mode(),     lot_frailty(),
                                           ageing()};
  return kinds;
}

std::span<const LifeKind> outside_life_kinds() {
  static const std::vector<LifeKind> kinds{rig_bias(), early_deaths()};
  return kinds;
}

}  // namespace host_sim::synth
