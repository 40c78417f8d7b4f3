#include "host_sim/report/replay/life_curve.hpp"

#include <cmath>

namespace host_sim {

LifeCurve life_curve(double damage_per_repeat, double weibull_shape, std::size_t points) {
  constexpr double kLastBroken = 0.999;
  LifeCurve curve;
  const double last_damage = std::pow(-std::log1p(-kLastBroken), 1 / weibull_shape);
  const double last_repeat = last_damage / damage_per_repeat;
  if (!(damage_per_repeat > 0) || !std::isfinite(damage_per_repeat) || !(weibull_shape > 0) ||
      !std::isfinite(last_repeat)) {
    return curve;
  }
  for (std::size_t i = 0; i < points; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(points - 1);
    curve.repeats.push_back(fraction * last_repeat);
    curve.broken.push_back(-std::expm1(-std::pow(fraction * last_damage, weibull_shape)));
  }
  return curve;
}

}  // namespace host_sim
