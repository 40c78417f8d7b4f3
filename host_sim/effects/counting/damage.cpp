#include "host_sim/effects/counting/damage.hpp"

#include "host_sim/reference/reference.hpp"

namespace host_sim::effects {

double damage_of(std::span<const double> tension_N, std::size_t step,
                 const reference::Constants& constants) {
  reference::Reference count(constants);
  for (std::size_t i = 0; i < tension_N.size(); i += step) {
    count.push(tension_N[i]);
  }
  return count.reading().damage.total;
}

double share_lost(double full, double left) {
  return full > 0 ? (full - left) / full : 0;
}

}  // namespace host_sim::effects
