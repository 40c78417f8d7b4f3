#include "host_sim/calibrate/damage.hpp"

#include <cmath>
#include <limits>

#include "host_sim/reference/equations.hpp"

namespace host_sim::calibrate {

double damage(const life_law::LifeDatum& datum, const life_law::LifeLaw& law) {
  double sum = 0;
  for (const life_law::LifeDatum::Block& block : datum.blocks) {
    sum += block.cycles / law.characteristic_life(block.effective_tension_N);
  }
  return sum;
}

double mean_damage(std::span<const life_law::LifeDatum> data, const life_law::LifeLaw& law) {
  double sum = 0;
  double sum_of_powers = 0;
  double failures = 0;
  for (const life_law::LifeDatum& datum : data) {
    const double used = damage(datum, law);
    sum += used;
    sum_of_powers += std::pow(used, law.shape);
    failures += datum.failed ? 1 : 0;
  }
  if (failures == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (failures == static_cast<double>(data.size())) {
    return sum / failures;
  }
  return std::pow(sum_of_powers / failures, 1 / law.shape) *
         reference::weibull_mean_damage(law.shape);
}

}  // namespace host_sim::calibrate
