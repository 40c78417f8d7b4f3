#include "host_sim/life_law/life_data.hpp"

#include <cmath>

#include "host_sim/reference/equations.hpp"

namespace host_sim::life_law {

double LifeLaw::characteristic_life(double effective_tension_N) const {
  return reference::ipl_life_cycles(effective_tension_N, scale, exponent);
}

double LifeLaw::mean_life(double effective_tension_N) const {
  return characteristic_life(effective_tension_N) * reference::weibull_mean_damage(shape);
}

double LifeLaw::quantile(double p, double effective_tension_N) const {
  return characteristic_life(effective_tension_N) * reference::weibull_life_damage(p, shape);
}

}  // namespace host_sim::life_law
