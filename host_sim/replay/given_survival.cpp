#include "host_sim/replay/given_survival.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hal/files/text.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/statistics/reach.hpp"

namespace host_sim {
namespace {

/// A law of life beside the fitted one.
struct Variant {
  double life_factor = 1;
  double shape = 0;
};

/// The ends of an interval of `value_of` over the variants of the law: effects on a scale where
/// they add, by `scale` and `unscale`.
template <class ValueOf, class Scale, class Unscale>
Estimate estimate(const std::vector<std::array<Variant, 2>>& variants, const Variant& fitted,
                  ValueOf value_of, Scale scale, Unscale unscale) {
  Estimate result{.value = value_of(fitted), .interval = {}};
  const double centre = scale(result.value);
  if (variants.empty() || !std::isfinite(centre)) {
    return result;
  }
  statistics::Reach reach;
  for (const auto& ends : variants) {
    reach.add(centre, scale(value_of(ends[0])), scale(value_of(ends[1])));
  }
  result.interval = {unscale(centre - reach.below), unscale(centre + reach.above)};
  return result;
}

std::vector<std::array<Variant, 2>> variants_of(const Model::Life& life,
                                                double effective_tension_N) {
  if (!life.interval || !(effective_tension_N > 0)) {
    return {};
  }
  const Model::Life::Interval& fit = *life.interval;
  const double life_half = std::log(fit.life_at_pivot.high / fit.life_at_pivot.low) / 2;
  const double exponent_half = (fit.ipl_exponent.high - fit.ipl_exponent.low) / 2;
  const double half =
      std::hypot(life_half, exponent_half * std::log(effective_tension_N / fit.pivot_tension_N));
  return {
      {Variant{std::exp(-half), life.weibull_shape}, Variant{std::exp(half), life.weibull_shape}},
      {Variant{1, fit.weibull_shape.low}, Variant{1, fit.weibull_shape.high}}};
}

/// Risk and life of a wire that is whole at a damage, under repeats of another.
class RiskLaw {
 public:
  RiskLaw(double used, double damage, double effective_tension_N, const Model::Life& life)
      : used_(used),
        damage_(damage),
        fitted_{1, life.weibull_shape},
        variants_(variants_of(life, effective_tension_N)) {}

  [[nodiscard]] bool has_interval() const { return !variants_.empty(); }

  [[nodiscard]] Estimate repeats_to(double risk) const {
    const auto repeats = [&](const Variant& law) {
      return damage_ == 0
                 ? std::numeric_limits<double>::infinity()
                 : reference::weibull_further_damage(used_ / law.life_factor, risk, law.shape) /
                       (damage_ / law.life_factor);
    };
    return estimate(
        variants_, fitted_, repeats, [](double x) { return std::log(x); },
        [](double x) { return std::exp(x); });
  }

  [[nodiscard]] Estimate risk_within(double repeats) const {
    const auto risk = [&](const Variant& law) {
      return reference::weibull_break_risk(used_ / law.life_factor,
                                           repeats * damage_ / law.life_factor, law.shape);
    };
    // ln(-ln(1 - p)), in which the shape and the logarithm of life are nearly linear.
    return estimate(
        variants_, fitted_, risk, [](double p) { return std::log(-std::log1p(-p)); },
        [](double x) { return -std::expm1(-std::exp(x)); });
  }

 private:
  double used_;
  double damage_;
  Variant fitted_;
  std::vector<std::array<Variant, 2>> variants_;
};

}  // namespace

std::optional<Horizon> horizon_from(const std::string& text) {
  const bool in_hours = !text.empty() && text.back() == 'h';
  const char* at = text.data();
  const char* const end = at + text.size() - (in_hours ? 1 : 0);
  double value = 0;
  if (!hal::files::parse_number(at, end, value) || at != end || !std::isfinite(value) ||
      !(value > 0)) {
    return std::nullopt;
  }
  return Horizon{value, in_hours, text};
}

GivenSurvival given_survival(const AskedOfSurvivor& asked, double damage, double duration_s,
                             double effective_tension_N, const Model::Life& life) {
  GivenSurvival result;
  result.used = asked.used;
  const RiskLaw law(asked.used, damage, effective_tension_N, life);
  result.level = law.has_interval() ? life.interval->level : 0;
  result.to_10 = law.repeats_to(0.1);
  result.to_50 = law.repeats_to(0.5);
  result.to_90 = law.repeats_to(0.9);
  if (asked.horizon) {
    const double repeats =
        asked.horizon->in_hours ? asked.horizon->value * 3600 / duration_s : asked.horizon->value;
    result.risk = {asked.horizon->text, repeats, law.risk_within(repeats)};
  }
  return result;
}

BreakCurve break_curve(double used, double damage, double effective_tension_N,
                       const Model::Life& life) {
  constexpr int kSteps = 200;
  BreakCurve curve;
  const RiskLaw law(used, damage, effective_tension_N, life);
  const double own_end = law.repeats_to(0.99).value;
  const RiskLaw of_new(0, damage, effective_tension_N, life);
  const double end = std::max(own_end, std::min(3 * own_end, of_new.repeats_to(0.9).value));
  if (!std::isfinite(end)) {
    return curve;
  }
  for (int i = 0; i <= kSteps; ++i) {
    const double repeats = end * i / kSteps;
    curve.repeats.push_back(repeats);
    curve.broken.push_back(law.risk_within(repeats));
    curve.broken_new.push_back(of_new.risk_within(repeats).value);
  }
  return curve;
}

}  // namespace host_sim
