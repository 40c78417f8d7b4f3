#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/life/conditional.hpp"
#include "lifemodel/life/uncertainty.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// What is not known for sure about how long a wire lasts, as half of the widths of 95 % intervals
/// of logarithms to base 2, Q21.
struct LifeSpread {
  std::uint32_t life = 0;   ///< of the characteristic life at the load
  std::uint32_t shape = 0;  ///< of the Weibull shape
  std::uint32_t load = 0;   ///< of the damage rate
};

/// log2 of a damage in Q26.
/// @pre above 0
constexpr std::int64_t log2_of(const Damage& damage) {
  const numeric::Normal d = normalise(damage);
  return (std::int64_t{d.exponent} << numeric::kLogBits) + numeric::log2_mantissa(d.mantissa);
}

/// The whole part of a square root.
constexpr std::uint32_t root(std::uint64_t square) {
  std::uint64_t result = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    const std::uint64_t larger = result | bit;
    result = larger * larger <= square ? larger : result;
  }
  return static_cast<std::uint32_t>(result);
}

namespace interval_detail {

/// damage * 2^log2, log2 in Q26.
/// @pre above 0
constexpr Damage scaled(const Damage& damage, std::int64_t log2) {
  return denormalise(numeric::product(normalise(damage), numeric::exp2(log2)));
}

/// The sums of the squares of deviations below and above, Q16 of log2.
class Deviations {
 public:
  /// What two variants deviate by, Q26.
  constexpr void add(std::int64_t one, std::int64_t other) {
    below_ += square(-std::min({one, other, std::int64_t{0}}));
    above_ += square(std::max({one, other, std::int64_t{0}}));
  }
  /// Their roots in Q26.
  [[nodiscard]] constexpr std::int64_t below() const { return std::int64_t{root(below_)} << kDrop; }
  [[nodiscard]] constexpr std::int64_t above() const { return std::int64_t{root(above_)} << kDrop; }

 private:
  static constexpr int kDrop = 10;
  static constexpr std::uint64_t square(std::int64_t value) {
    const auto narrow = static_cast<std::uint64_t>(value >> kDrop);
    return narrow * narrow;
  }
  std::uint64_t below_ = 0;
  std::uint64_t above_ = 0;
};

}  // namespace interval_detail

/// The ends of an interval in damage at the law and the rate that are taken for the true ones.
struct FurtherDamageInterval {
  Damage low;
  Damage high;
};

/// The 95 % interval of further_damage() as time would have it at the present rate. Life, shape and
/// load are taken as independent, the deviations of the logarithm added as the root of the sum of
/// their squares, each end on its own. A life that is shorter makes `used` larger as well.
constexpr FurtherDamageInterval further_damage_interval(WeibullShape shape, const Damage& used,
                                                        Hazard hazard, const LifeSpread& spread) {
  using namespace interval_detail;
  constexpr int kUp = numeric::kLogBits - numeric::kExpBits;
  const Damage middle = further_damage(shape, used, hazard);
  if (middle.none()) {
    return {};
  }
  const std::int64_t centre = log2_of(middle);
  // A wire whose life is 2^longer of the fitted one.
  const auto by_life = [&](std::int64_t longer) {
    const Damage of_that_life = used.none() ? used : scaled(used, -longer);
    const Damage further = further_damage(shape, of_that_life, hazard);
    return further.none() ? -(std::int64_t{128} << numeric::kLogBits)
                          : log2_of(further) + longer - centre;
  };
  const auto by_shape = [&](std::int64_t larger) {
    const numeric::Normal scaled_shape =
        numeric::product(numeric::normal(shape.raw(), 0), numeric::exp2(larger));
    const std::uint32_t raw = scaled_shape.exponent > 30 ? WeibullShape::highest().raw()
                                                         : numeric::fixed(scaled_shape, 0);
    const Damage further =
        further_damage(WeibullShape::from_raw(std::clamp(raw, WeibullShape::lowest().raw(),
                                                         WeibullShape::highest().raw())),
                       used, hazard);
    return further.none() ? -(std::int64_t{128} << numeric::kLogBits) : log2_of(further) - centre;
  };
  const std::int64_t life = std::int64_t{spread.life} << kUp;
  const std::int64_t beta = std::int64_t{spread.shape} << kUp;
  const std::int64_t load = std::int64_t{spread.load} << kUp;
  Deviations deviations;
  deviations.add(by_life(-life), by_life(life));
  deviations.add(by_shape(-beta), by_shape(beta));
  deviations.add(-load, load);
  return {scaled(middle, -deviations.below()), scaled(middle, deviations.above())};
}

/// Half of the width of the 95 % interval of log2 of the characteristic life at a load whose cycles
/// do 2^log2_damage each, Q21; see LifeUncertainty.
constexpr std::uint32_t life_spread(const LifeUncertainty& fit, IplExponent exponent,
                                    std::int32_t log2_damage) {
  const std::int64_t distance = std::int64_t{log2_damage} - fit.log2_damage_at_pivot;
  const auto away = static_cast<std::uint64_t>(distance < 0 ? -distance : distance);
  const std::uint32_t share =
      fit.exponent == 0 ? 0
                        : numeric::fixed(numeric::quotient(numeric::normal(fit.exponent, 0),
                                                           numeric::normal(exponent.raw(), 0)),
                                         20);
  // Q16, so that the squares have room.
  const std::uint64_t by_exponent = std::min<std::uint64_t>((away * share) >> 25, 1u << 28);
  const std::uint64_t by_life = fit.log2_life >> 5;
  return root(by_exponent * by_exponent + by_life * by_life) << 5;
}

}  // namespace lifemodel
