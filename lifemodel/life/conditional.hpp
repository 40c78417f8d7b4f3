#pragma once

#include <cstdint>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/life/weibull.hpp"
#include "lifemodel/numeric/near_zero.hpp"
#include "lifemodel/quantity/units.hpp"

/// Life given survival: of a wire that is known to be whole at damage D. By (15) its survival of a
/// further damage d is
///   R(D + d) / R(D) = exp(-((D + d)^beta - D^beta)),
/// which at D = 0 is the life distribution itself and at beta = 1 does not depend on D. A wire that
/// has reached its B10 is at 10 % risk again after a fraction of it.
namespace lifemodel {

/// The cumulative hazard -ln(1 - x) that goes with a risk x, as its logarithm to base 2 in Q26.
struct Hazard {
  std::int32_t log2;

  /// Relative error at most 1.5e-6.
  /// @pre 0 < risk < 1
  static constexpr Hazard of(Ratio risk) {
    const numeric::Normal x = numeric::normal(risk.raw(), -Ratio::kFractionBits);
    numeric::Normal hazard{};
    if (x.exponent < -4) {
      const auto t = -static_cast<std::int32_t>(numeric::fixed(x, 31));
      hazard = numeric::product(x, numeric::normal(numeric::at(numeric::kLogSeries, t), -30));
    } else {
      const numeric::Normal whole =
          numeric::normal(Ratio::highest().raw() - risk.raw(), -Ratio::kFractionBits);
      hazard = numeric::product(
          numeric::normal(static_cast<std::uint32_t>(-numeric::log2(whole)), -numeric::kLogBits),
          numeric::kLn2);
    }
    return {numeric::log2(hazard)};
  }
};

inline constexpr Hazard kHazard10{-217875221};  ///< log2(-ln 0.9)
inline constexpr Hazard kHazard50{-35484911};   ///< log2(ln 2)
inline constexpr Hazard kHazard90{80749041};    ///< log2(ln 10)

/// log2 of hazard / used^shape from which on the latter is nothing beside it, Q26.
inline constexpr std::int64_t kNothingUsed = std::int64_t{30} << numeric::kLogBits;

/// The damage that a wire which is whole at `used` takes until it has broken with the probability
/// of `hazard`: d with (used + d)^shape = used^shape + hazard. Rounded down to 2^-104; relative
/// error at most 2e-6 + 1e-7 shape, so for risks of 10 to 90 % at most 5e-6 characteristic lives
/// where the shape is at least 1.
///
/// It is formed as S (1 - used / S) with S = used + d, and log2(S / used) from log2(1 + hazard /
/// used^shape), so that nothing cancels where d is far below `used`.
constexpr Damage further_damage(WeibullShape shape, const Damage& used, Hazard hazard) {
  const numeric::Normal beta = numeric::normal(shape.raw(), -WeibullShape::kFractionBits);
  const numeric::Normal d = used.none() ? numeric::Normal{} : normalise(used);
  const std::int64_t log2_ratio = used.none() ? kNothingUsed : hazard.log2 - log2_power(d, shape);
  // Exponents are below 128: half of them has one fraction bit less.
  const auto half = [](numeric::Normal exponent) {
    return static_cast<std::int64_t>(numeric::fixed(exponent, numeric::kLogBits - 1));
  };
  if (log2_ratio >= kNothingUsed) {
    const auto magnitude =
        static_cast<std::uint32_t>(hazard.log2 < 0 ? -std::int64_t{hazard.log2} : hazard.log2);
    const std::int64_t root =
        half(numeric::quotient(numeric::normal(magnitude | 1u, -numeric::kLogBits), beta));
    const Damage life = denormalise(numeric::exp2(2 * (hazard.log2 < 0 ? -root : root)));
    return life > used ? Damage::difference(life, used) : Damage{};
  }
  const numeric::Normal log2_growth =
      numeric::quotient(numeric::log2_of_one_plus(numeric::exp2(log2_ratio)), beta);
  return denormalise(numeric::product(numeric::product(d, numeric::exp2(2 * half(log2_growth))),
                                      numeric::one_minus_exp2_of_minus(log2_growth)));
}

/// The same for a risk: none at 0, the highest damage there is at 1, which no wire is sure to
/// reach.
constexpr Damage further_damage(WeibullShape shape, const Damage& used, Ratio risk) {
  if (risk == Ratio::lowest()) {
    return {};
  }
  return risk == Ratio::highest() ? Damage::highest()
                                  : further_damage(shape, used, Hazard::of(risk));
}

/// The probability that a wire which is whole at `used` has broken after a `further` damage;
/// relative error at most 2e-6 + 1e-7 shape, and 2^-30.
constexpr Ratio break_risk(WeibullShape shape, const Damage& used, const Damage& further) {
  if (further.none()) {
    return Ratio::lowest();
  }
  Damage sum = used;
  Flags saturated;
  sum.add(further, saturated);
  const std::int64_t log2_power_of_sum = log2_power(normalise(sum), shape);
  numeric::Normal share{1u << numeric::kMantissaBits, 0};
  if (!used.none()) {
    const numeric::Normal ratio = numeric::quotient(normalise(further), normalise(used));
    if (ratio.exponent < 62) {
      share = numeric::one_minus_exp2_of_minus(
          numeric::product(numeric::log2_of_one_plus(ratio),
                           numeric::normal(shape.raw(), -WeibullShape::kFractionBits)));
    }
  }
  const numeric::Normal hazard = numeric::product(numeric::exp2(log2_power_of_sum), share);
  const numeric::Normal risk =
      numeric::one_minus_exp2_of_minus(numeric::product(hazard, numeric::kLog2E));
  return Ratio::from_raw(numeric::fixed(risk, Ratio::kFractionBits));
}

}  // namespace lifemodel
