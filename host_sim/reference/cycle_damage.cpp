#include "host_sim/reference/cycle_damage.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reference/equations.hpp"

namespace host_sim::reference {

bool is_overload(const Cycle& cycle, const Constants& constants) {
  return std::max(std::abs(cycle.from_N), std::abs(cycle.to_N)) >= constants.ultimate_tension_N;
}

double cycle_damage(const Cycle& cycle, const Constants& constants) {
  return cycle_damage(cycle, constants, {});
}

double cycle_damage(const Cycle& cycle, const Constants& constants,
                    const EffectiveTension& effective) {
  if (is_overload(cycle, constants)) {
    return 1.0;
  }
  const MeanAmplitude input{.mean_N = (cycle.from_N + cycle.to_N) / 2.0,
                            .amplitude_N = std::abs(cycle.from_N - cycle.to_N) / 2.0};
  const double gerber_N = gerber_effective_tension(input, constants.ultimate_tension_N);
  const double effective_N = effective ? effective(input, gerber_N) : gerber_N;
  return std::min(1.0,
                  1.0 / ipl_life_cycles(effective_N, constants.ipl_scale, constants.ipl_exponent));
}

}  // namespace host_sim::reference
