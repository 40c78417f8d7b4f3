#include "host_sim/reference/life.hpp"

#include <cmath>
#include <limits>

#include "host_sim/reference/equations.hpp"

namespace host_sim::reference {
namespace {

double power_mean(std::span<const TensionShare> mix, double order) {
  double sum = 0.0;
  for (const TensionShare& part : mix) {
    sum += part.share * std::pow(part.effective_tension_N, order);
  }
  return std::pow(sum, 1.0 / order);
}

}  // namespace

LifePoints damage_to(double weibull_shape) {
  return {.b10 = weibull_life_damage(0.1, weibull_shape),
          .b50 = weibull_life_damage(0.5, weibull_shape),
          .mean = weibull_mean_damage(weibull_shape),
          .b90 = weibull_life_damage(0.9, weibull_shape)};
}

LifePoints repeats_to(double damage_per_repeat, double weibull_shape) {
  if (damage_per_repeat == 0.0) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    return {.b10 = kNever, .b50 = kNever, .mean = kNever, .b90 = kNever};
  }
  const LifePoints damage = damage_to(weibull_shape);
  return {.b10 = damage.b10 / damage_per_repeat,
          .b50 = damage.b50 / damage_per_repeat,
          .mean = damage.mean / damage_per_repeat,
          .b90 = damage.b90 / damage_per_repeat};
}

double equivalent_cycles(const Reading& reading) {
  return static_cast<double>(reading.closed_cycles) +
         static_cast<double>(reading.open_half_cycles) / 2.0;
}

double equivalent_effective_tension(const Reading& reading, const Constants& constants) {
  const double cycles = equivalent_cycles(reading);
  if (cycles == 0.0) {
    return 0.0;
  }
  return std::pow(reading.damage.total * constants.ipl_scale / cycles,
                  1.0 / constants.ipl_exponent);
}

double mix_by_damage(std::span<const TensionShare> mix, double ipl_exponent) {
  return power_mean(mix, ipl_exponent);
}

double mix_by_life(std::span<const TensionShare> mix, double ipl_exponent) {
  return power_mean(mix, -ipl_exponent);
}

}  // namespace host_sim::reference
