#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/damage/cycle_law.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/life/conditional.hpp"
#include "lifemodel/life/weibull.hpp"
#include "lifemodel/numeric/near_zero.hpp"
#include "lifemodel/quantity/units.hpp"

/// How much a drive would have to give up for a wire to last: the load that its damage allows. It
/// is advice; nothing here acts on it.
namespace lifemodel {

/// The lowest tension of a cycle over its highest, Q1.30: -1 .. 1.
struct LoadRatio {
  static constexpr std::int32_t kOne = 1 << 30;
  std::int32_t raw = -kOne;
};

/// Floor of the square root.
constexpr std::uint32_t square_root(std::uint64_t x) {
  std::uint32_t root = 0;
  std::uint64_t left = x;
  for (int bit = 31; bit >= 0; --bit) {
    const std::uint64_t with = ((std::uint64_t{root} << 1) | (std::uint64_t{1} << bit)) << bit;
    if (with <= left) {
      left -= with;
      root |= std::uint32_t{1} << bit;
    }
  }
  return root;
}

/// The highest tension T of a cycle with this load ratio whose effective tension is
/// 2^log2_effective of the ultimate one, log2 in Q26: by Gerber (11) with T_a = a T and T_m = m T,
/// a = (1 - R) / 2 and m = (1 + R) / 2, of T_e m^2 T^2 + a T - T_e = 0 the root
///   T = 2 T_e / (a + sqrt(a^2 + 4 T_e^2 m^2)),
/// which has no difference in which digits cancel. Relative to the ultimate tension, Q30, rounded
/// down; relative error at most 2e-7 above 2^-8, and 2^-30. The ultimate one at most.
/// @pre ratio.raw < LoadRatio::kOne
constexpr Ratio highest_tension(std::int64_t log2_effective, LoadRatio ratio) {
  if (log2_effective >= std::int64_t{2} << numeric::kLogBits) {
    return Ratio::highest();
  }
  const numeric::Normal effective = numeric::exp2(log2_effective);
  if (effective.exponent < -30) {
    return Ratio::lowest();
  }
  // In Q30: a 0 .. 1, m 0 .. 1, 2 T_e m 0 .. 8.
  constexpr std::uint32_t kOne = LoadRatio::kOne;
  const auto bits = static_cast<std::uint32_t>(ratio.raw);
  const std::uint32_t a = std::max<std::uint32_t>((kOne - bits) >> 1, 1);
  const std::uint32_t m = (kOne + bits) >> 1;
  const std::uint64_t twice_m =
      (std::uint64_t{numeric::fixed(effective, 28)} * m) >> (28 - 1);  // 2 T_e m, Q30
  const std::uint64_t squares = ((std::uint64_t{a} * a) >> 6) + ((twice_m >> 3) * (twice_m >> 3));
  const std::uint64_t root = std::uint64_t{square_root(squares)} << 3;  // of Q54, so Q27, to Q30
  const numeric::Normal inverse = numeric::quotient(1u << 31, std::uint64_t{a} + root);
  const numeric::Normal tension = numeric::product(effective, inverse);
  // inverse is 2^31 over Q30: twice the inverse.
  return tension.exponent >= 0 ? Ratio::highest()
                               : Ratio::from_raw(numeric::fixed(tension, Ratio::kFractionBits));
}

/// The load that stands for all of a wire: the cycle up to its highest tension which does the
/// damage of its cycles on average.
struct RepresentativeCycle {
  std::int64_t log2_effective = 0;  ///< of its effective tension over the ultimate one, Q26
  LoadRatio ratio;

  /// Of an effective tension, log2 in Q26, and the highest one that there was. By Gerber the mean m
  /// of the two solves T_e m^2 - m + (T - T_e) = 0; where T_e is not below T there is none.
  static constexpr RepresentativeCycle of(std::int64_t log2_effective, Tension peak) {
    RepresentativeCycle cycle{log2_effective, {}};
    constexpr std::uint32_t kOne = 1u << 30;
    const std::uint32_t top =
        std::min(static_cast<std::uint32_t>(std::max<std::int32_t>(peak.raw(), 0)) << 1, kOne);
    if (log2_effective >= 0) {
      return cycle;
    }
    const std::uint32_t effective = numeric::fixed(numeric::exp2(log2_effective), 30);
    if (effective >= top) {
      return cycle;
    }
    const std::uint32_t rest = top - effective;
    const std::uint64_t squares = (std::uint64_t{1} << 60) - 4 * (std::uint64_t{effective} * rest);
    const std::uint64_t root = std::uint64_t{square_root(squares >> 6)} << 3;
    // 2 (T - T_e) / (1 + root), which is the lesser root without a difference.
    const numeric::Normal mean = numeric::quotient(rest, kOne + root);
    const std::uint32_t twice_mean_over_top =
        numeric::fixed(numeric::quotient(mean, numeric::normal(top, -30)), 28);
    cycle.ratio.raw = static_cast<std::int32_t>(std::int64_t{twice_mean_over_top} * 16 - kOne);
    return cycle;
  }
  /// Of the damage of a cycle on average, by a law.
  /// @pre damage > 0
  static constexpr RepresentativeCycle of(const CycleLaw& law, numeric::Normal damage,
                                          Tension peak) {
    return of(divide(log2_of(damage) - (std::int64_t{law.log2_damage_at_ultimate}
                                        << (numeric::kLogBits - numeric::kExpBits)),
                     law.exponent),
              peak);
  }

  /// log2 in Q26, whatever the exponent.
  static constexpr std::int64_t log2_of(numeric::Normal x) {
    return (std::int64_t{x.exponent} << numeric::kLogBits) + numeric::log2_mantissa(x.mantissa);
  }
  /// A logarithm in Q26 over gamma, rounded down.
  static constexpr std::int64_t divide(std::int64_t log2, IplExponent gamma) {
    if (log2 == 0) {
      return 0;
    }
    const bool negative = log2 < 0;
    const auto size = static_cast<std::uint64_t>(negative ? -log2 : log2);
    // Up to 604, which 37 bits hold.
    const int drop = size >> 32 != 0 ? 5 : 0;
    const auto whole = static_cast<std::uint32_t>(size >> drop);
    const std::uint32_t value =
        numeric::fixed(numeric::quotient(whole, gamma.raw()), IplExponent::kFractionBits);
    const auto result = static_cast<std::int64_t>(std::uint64_t{value} << drop);
    return negative ? -result - (std::int64_t{1} << drop) : result;
  }
};

/// What a wire may do so that it lasts as long as is wanted, at the risk that is accepted: either
/// of the two, with the other as it is.
struct Advice {
  /// The highest tension of its representative cycle, relative to the ultimate one.
  Ratio tension = Ratio::highest();
  /// Cycles in a time, relative to as many as there are; no more than there are.
  Ratio pace = Ratio::highest();

  friend constexpr bool operator==(const Advice&, const Advice&) = default;
};

/// A number as a ratio, rounded down; 1 at most.
constexpr Ratio ratio_of(numeric::Normal number) {
  return number.exponent >= 0 ? Ratio::highest()
                              : Ratio::from_raw(numeric::fixed(number, Ratio::kFractionBits));
}

/// Cycles in a time, relative to as many as do `needed` damage until the date, so that they do no
/// more than `allowed`; no more than there are.
constexpr Ratio pace(const Damage& allowed, const Damage& needed) {
  if (needed.none()) {
    return Ratio::highest();
  }
  return allowed.none() ? Ratio::lowest()
                        : ratio_of(numeric::quotient(normalise(allowed), normalise(needed)));
}

/// The advice for a wire that may take `allowed` damage until the date, and takes `needed` as it
/// goes on now: the one over the other is the pace, and its gamma-th root scales the effective
/// tension.
constexpr Advice advise(const CycleLaw& law, const Damage& allowed, const Damage& needed,
                        const RepresentativeCycle& cycle) {
  if (needed.none()) {
    return {};
  }
  if (allowed.none()) {
    return {Ratio::lowest(), Ratio::lowest()};
  }
  const numeric::Normal share = numeric::quotient(normalise(allowed), normalise(needed));
  const std::int64_t log2_share = RepresentativeCycle::log2_of(share);
  return {
      highest_tension(cycle.log2_effective + RepresentativeCycle::divide(log2_share, law.exponent),
                      cycle.ratio),
      ratio_of(share)};
}

/// The same for a wire that is whole at `used` and may be broken at the date with the probability
/// of `hazard`. More wear, less risk and a later date never raise it but by the error of the
/// logarithms, 2e-6 of the tension.
constexpr Advice advise(const CycleLaw& law, WeibullShape shape, const Damage& used, Hazard hazard,
                        const Damage& needed, const RepresentativeCycle& cycle) {
  return advise(law, further_damage(shape, used, hazard), needed, cycle);
}

/// Advice as a drive hears it: it falls at once, and rises by no more than a step each time, so
/// that a drive that follows it does not swing with its own load.
class SteadyAdvice {
 public:
  /// 1/1024 of the whole: a thousandth of the ultimate tension, or of the pace.
  static constexpr std::uint32_t kStep = 1u << (Ratio::kFractionBits - 10);

  constexpr void take(const Advice& wanted) {
    if (!heard_) {
      advice_ = wanted;
      heard_ = true;
      return;
    }
    advice_.tension = no_faster(advice_.tension, wanted.tension);
    advice_.pace = no_faster(advice_.pace, wanted.pace);
  }
  /// Without a limit until something was taken.
  [[nodiscard]] constexpr const Advice& advice() const { return advice_; }

 private:
  static constexpr Ratio no_faster(Ratio last, Ratio wanted) {
    return Ratio::from_raw(std::min(wanted.raw(), last.raw() + kStep));
  }

  Advice advice_;
  bool heard_ = false;
};

}  // namespace lifemodel
