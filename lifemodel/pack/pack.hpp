#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "lifemodel/block/parameter_block.hpp"

/// For the host: computes parameter blocks and converts quantities from and to double.
namespace lifemodel::pack {

/// The nearest value of a quantity; the closed range is not left, NaN becomes the lowest value.
template <class Q>
Q from_double(double value) {
  using Rep = typename Q::Rep;
  const double scaled = value * std::ldexp(1.0, Q::kFractionBits);
  if (!(scaled > static_cast<double>(Q::lowest().raw()))) {
    return Q::lowest();
  }
  if (scaled >= static_cast<double>(Q::highest().raw())) {
    return Q::highest();
  }
  if constexpr (sizeof(Rep) <= sizeof(std::int32_t)) {
    // As std::nearbyint(), without the call: so large that a step is 1, the sum rounds.
    constexpr double kWhole = 0x1.8p52;
    return Q::from_raw(static_cast<Rep>((scaled + kWhole) - kWhole));
  } else {
    return Q::from_raw(static_cast<Rep>(std::nearbyint(scaled)));
  }
}

/// The value of a quantity, exactly.
template <class Q>
double to_double(Q quantity) {
  return std::ldexp(static_cast<double>(quantity.raw()), -Q::kFractionBits);
}

inline double to_double(const Damage& damage) {
  double sum = 0;
  for (std::size_t i = 0; i < damage.words().size(); ++i) {
    sum += std::ldexp(static_cast<double>(damage.words()[i]),
                      static_cast<int>(i) * 32 - Damage::kFractionBits);
  }
  return sum;
}

inline double to_double(CycleDamage damage) {
  return std::ldexp(static_cast<double>(damage.mantissa), damage.position - Damage::kFractionBits);
}

/// Rounded down to 2^-104 and 32 bits; saturates.
/// @pre lives >= 0
inline Damage damage(double lives) {
  constexpr int kBits = 32;
  Damage damage;
  int exponent = 0;
  const double mantissa = std::frexp(std::min(lives, 1e9), &exponent);
  const int position = Damage::kFractionBits + exponent - kBits;
  if (position > -kBits) {
    Flags none;
    damage.add({static_cast<std::uint32_t>(std::ldexp(mantissa, kBits)), position}, none);
  }
  return damage;
}

/// Tension relative to the ultimate tension.
inline Tension tension(double tension_N, double ultimate_tension_N) {
  return from_double<Tension>(tension_N / ultimate_tension_N);
}

/// The ultimate tension of parameters: in whole mN where the scale is that of it, else what the
/// scale follows from.
inline double ultimate_tension_N(const Parameters& p) {
  const Factor& scale = p.scale.steps_per_mN;
  const double whole_N = p.ultimate_mN * 1e-3;
  const double scaled_N = std::ldexp(1e-3, Tension::kFractionBits + scale.shift) / scale.mantissa;
  constexpr double kRounding = 1e-9;  // of a mantissa of 31 bits
  return std::fabs(scaled_N / whole_N - 1) < kRounding ? whole_N : scaled_N;
}

/// The factor nearest to this one, or nothing where it cannot be represented.
inline std::optional<Factor> factor(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  if (!std::isfinite(value)) {
    return std::nullopt;
  }
  const double scaled = std::nearbyint(std::ldexp(mantissa, 31));
  const Factor result{static_cast<std::int32_t>(std::min(scaled, 2147483647.0)), 31 - exponent};
  return result.plausible() ? std::optional(result) : std::nullopt;
}

/// 95 % intervals of the numbers of a life law; see LifeUncertainty.
struct FitIntervals {
  struct Ends {
    double low;
    double high;
  };
  Ends ipl_exponent;
  Ends weibull_shape;
  double pivot_tension_N;  ///< effective
  Ends life_at_pivot;      ///< characteristic life in cycles
};

/// What is watched, see WatchLimits; 0 is off.
struct Watch {
  double minimum_tension_N = 0;
  double broken_tension_N = 0;
  double broken_travel_mm = 0;
  double slack_travel_mm = 0;
  double horizon_h = 0;
  double advice_risk = 0;
  double advice_until_h = 0;
};

/// The model in physical units; see the ranges of BlockError.
struct Constants {
  double ultimate_tension_N = 0;
  double hysteresis_N = 0;  ///< smallest range that is counted; zero counts every range
  double ipl_scale = 0;     ///< A of (19), for tensions in N
  double ipl_exponent = 0;  ///< gamma of (19)
  double weibull_shape = 0;
  double friction_coefficient = 0;
  double bend_angle_rad = 0;
  std::optional<double> tension_per_current_N_A;  ///< K_t N eta_g / r_spool, where there is a drive
  double current_offset_A = 0;
  double sample_period_s = 0;
  std::uint32_t model_digest = 0;
  std::optional<FitIntervals> intervals = {};
  Watch watch = {};
};

/// Half of the widths of intervals, wider ones as wide as a block can hold; nothing where the pivot
/// is none that it can hold.
inline std::optional<LifeUncertainty> uncertainty(const Constants& c) {
  const auto half_width = [](double low, double high, int fraction_bits, std::uint32_t widest) {
    const double raw = std::nearbyint(std::ldexp((high - low) / 2, fraction_bits));
    return raw < widest ? static_cast<std::uint32_t>(std::max(raw, 0.0)) : widest;
  };
  const FitIntervals& fit = *c.intervals;
  const double log2_damage = std::nearbyint(std::ldexp(
      c.ipl_exponent * std::log2(fit.pivot_tension_N) - std::log2(c.ipl_scale), numeric::kExpBits));
  if (!(std::fabs(log2_damage) <= kHighestLog2Life)) {
    return std::nullopt;
  }
  return LifeUncertainty{
      .log2_life = half_width(std::log2(fit.life_at_pivot.low), std::log2(fit.life_at_pivot.high),
                              numeric::kExpBits, LifeUncertainty::kWidestLog2Life),
      .exponent = half_width(fit.ipl_exponent.low, fit.ipl_exponent.high,
                             IplExponent::kFractionBits, LifeUncertainty::kWidestExponent),
      .log2_shape = half_width(std::log2(fit.weibull_shape.low), std::log2(fit.weibull_shape.high),
                               numeric::kExpBits, LifeUncertainty::kWidestLog2Shape),
      .log2_damage_at_pivot = static_cast<std::int32_t>(log2_damage)};
}

/// Limits in fixed point, or nothing where they are none that a block can hold. What is not off
/// does not become so by rounding.
inline std::optional<WatchLimits> watch_limits(const Watch& w, double ultimate_tension_N) {
  const auto word = [](double value, int fraction_bits) {
    const double raw = std::nearbyint(std::ldexp(value, fraction_bits));
    const double most = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(value > 0 ? std::clamp(raw, 1.0, most) : 0.0);
  };
  if (!(w.minimum_tension_N < ultimate_tension_N) || !(w.broken_tension_N < ultimate_tension_N) ||
      !(w.advice_risk < 1)) {
    return std::nullopt;
  }
  const auto tension_of = [&](double tension_N) {
    return Tension::from_raw(static_cast<std::int32_t>(
        std::min(word(tension_N / ultimate_tension_N, Tension::kFractionBits),
                 static_cast<std::uint32_t>(kUltimate.raw()) - 1)));
  };
  const WatchLimits limits{
      .minimum = tension_of(w.minimum_tension_N),
      .broken = tension_of(w.broken_tension_N),
      .broken_travel_um = word(w.broken_travel_mm * 1e3, 0),
      .slack_travel_um = word(w.slack_travel_mm * 1e3, 0),
      .horizon_s = word(w.horizon_h * 3600, 0),
      .advice_risk = Ratio::from_raw(
          std::min(word(w.advice_risk, Ratio::kFractionBits), Ratio::highest().raw() - 1)),
      .advice_until_s = word(w.advice_until_h * 3600, 0)};
  return plausible(limits) ? std::optional(limits) : std::nullopt;
}

/// Parameters for these constants, or why there are none.
inline Result<Parameters, BlockError> parameters(const Constants& c) {
  const auto within = [](double value, double low, double high) {
    return value >= low && value <= high;
  };
  if (!within(c.ultimate_tension_N, 1, 1e6)) {
    return BlockError::ultimate_tension;
  }
  if (!within(c.hysteresis_N, 0, c.ultimate_tension_N * (1 - 1e-9))) {
    return BlockError::hysteresis;
  }
  if (!within(c.ipl_exponent, 1, 12)) {
    return BlockError::ipl_exponent;
  }
  if (!within(c.weibull_shape, 0.5, 50)) {
    return BlockError::weibull_shape;
  }
  if (!within(c.friction_coefficient, 0, 1)) {
    return BlockError::friction_coefficient;
  }
  if (!within(c.bend_angle_rad, 0, 10 * std::numbers::pi)) {
    return BlockError::bend_angle;
  }
  if (!within(c.sample_period_s, 1e-6, 4000)) {
    return BlockError::sample_period;
  }
  const double log2_damage_at_ultimate =
      c.ipl_exponent * std::log2(c.ultimate_tension_N) - std::log2(c.ipl_scale);
  if (!(c.ipl_scale > 0) || !(std::fabs(log2_damage_at_ultimate) <= 500)) {
    return BlockError::ipl_scale;
  }

  Parameters p{};
  p.model_digest = c.model_digest;
  p.ultimate_mN = static_cast<std::uint32_t>(std::lround(c.ultimate_tension_N * 1e3));
  p.scale.steps_per_mN = *factor(std::ldexp(1e-3 / c.ultimate_tension_N, Tension::kFractionBits));
  // Both ends of a range are rounded by up to half a step, so a range of just the hysteresis may
  // come out one step short: it is counted all the same.
  const double hysteresis =
      std::floor(std::ldexp(c.hysteresis_N / c.ultimate_tension_N, TensionRange::kFractionBits)) -
      1;
  p.hysteresis = TensionRange::from_raw(static_cast<std::uint32_t>(std::max(hysteresis, 1.0)));
  p.law.exponent = from_double<IplExponent>(c.ipl_exponent);
  p.law.log2_damage_at_ultimate = static_cast<std::int32_t>(
      std::lround(std::ldexp(log2_damage_at_ultimate, numeric::kExpBits)));
  p.life.shape = from_double<WeibullShape>(c.weibull_shape);
  const auto life_point = [](double damage) {
    return LifePoint{
        static_cast<std::uint32_t>(std::lround(std::ldexp(damage, LifePoint::kFractionBits)))};
  };
  const auto broken = [&](double part) {
    return life_point(std::pow(-std::log1p(-part), 1 / c.weibull_shape));
  };
  p.life.b10 = broken(0.10);
  p.life.b50 = broken(0.50);
  p.life.mean = life_point(std::tgamma(1 + 1 / c.weibull_shape));
  p.life.b90 = broken(0.90);
  p.capstan.friction = from_double<FrictionExponent>(c.friction_coefficient * std::numbers::log2e);
  p.bend = from_double<Angle>(c.bend_angle_rad);
  p.drive = {};
  if (c.tension_per_current_N_A) {
    const auto gain = factor(std::ldexp(*c.tension_per_current_N_A / c.ultimate_tension_N,
                                        Tension::kFractionBits - MotorCurrent::kFractionBits));
    if (!gain || !within(c.current_offset_A, -127, 127)) {
      return BlockError::drive;
    }
    p.drive = {from_double<MotorCurrent>(c.current_offset_A), *gain};
  }
  p.sample_period_us = static_cast<std::uint32_t>(std::lround(c.sample_period_s * 1e6));
  if (c.intervals) {
    const auto known = uncertainty(c);
    if (!known) {
      return BlockError::uncertainty;
    }
    p.uncertainty = *known;
  }
  const auto limits = watch_limits(c.watch, c.ultimate_tension_N);
  if (!limits) {
    return BlockError::watch_limits;
  }
  p.watch = *limits;
  return p;
}

}  // namespace lifemodel::pack
