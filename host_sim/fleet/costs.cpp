#include "host_sim/fleet/costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "hal/files/input_error.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim::fleet {

using hal::files::in_quotes;
using hal::files::InputError;

void set_costs(Fleet& fleet, std::optional<double> replacement, std::optional<double> of_break,
               std::string_view source) {
  const auto give = [&](std::optional<double> Tendon::*cost, std::optional<double> of_all,
                        std::string_view column, std::string_view option) {
    for (Tendon& tendon : fleet.tendons) {
      tendon.*cost = tendon.*cost ? tendon.*cost : of_all;
      if (!(tendon.*cost)) {
        throw InputError(source, 0, 0,
                         fmt::format("tendon {} has no {}", in_quotes(tendon.name), column),
                         fmt::format("{} for all, or {} of each tendon", option, column));
      }
    }
  };
  const bool any = std::any_of(
      fleet.tendons.begin(), fleet.tendons.end(),
      [](const Tendon& tendon) { return tendon.replacement_cost || tendon.break_cost; });
  if (!any && !replacement && !of_break) {
    return;
  }
  give(&Tendon::replacement_cost, replacement, "cost_replace", "--cost-replacement");
  give(&Tendon::break_cost, of_break, "cost_break", "--cost-break");
  for (const Tendon& tendon : fleet.tendons) {
    if (*tendon.break_cost < *tendon.replacement_cost) {
      throw InputError(source, 0, 0,
                       fmt::format("a break of tendon {} costs {:g}, less than its replacement",
                                   in_quotes(tendon.name), *tendon.break_cost),
                       fmt::format("{:g} or more: the replacement after it is part of it",
                                   *tendon.replacement_cost));
    }
  }
}

double mean_damage(double shape, double limit) {
  const double whole = std::tgamma(1 + 1 / shape);
  return std::isinf(limit) ? whole
                           : whole * boost::math::gamma_p(1 / shape, std::pow(limit, shape));
}

double cost_per_damage(double shape, double limit, const TendonCosts& costs) {
  const double survives = std::exp(-std::pow(limit, shape));
  return (costs.of_break + (costs.replacement - costs.of_break) * survives) /
         mean_damage(shape, limit);
}

double cheapest_limit(double shape, const TendonCosts& costs) {
  const double ratio = costs.replacement / (costs.of_break - costs.replacement);
  if (shape <= 1 || !std::isfinite(ratio)) {
    return std::numeric_limits<double>::infinity();
  }
  // Beyond, R is below any number, and to replace at once is below any cost.
  double low = 1e-12;
  double high = std::pow(700.0, 1 / shape);
  const auto excess = [&](double limit) {
    return shape * std::pow(limit, shape - 1) * mean_damage(shape, limit) +
           std::expm1(-std::pow(limit, shape)) - ratio;
  };
  if (excess(high) < 0) {
    return std::numeric_limits<double>::infinity();
  }
  constexpr int kHalvings = 100;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::sqrt(low * high);
    (excess(middle) < 0 ? low : high) = middle;
  }
  return high;
}

double limit_on_condition(double shape, double between, double risk) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double hazard = -std::log1p(-risk);
  const auto reaches = [&](double span) {
    return hazard_growth(span * between, between, shape) >= hazard;
  };
  if (between <= 0) {
    return kNever;
  }
  double last = 0;
  if (!reaches(0)) {
    if (shape <= 1) {
      return kNever;  // the risk of a span never grows
    }
    // Beyond characteristic lives of thousands no wire is whole.
    double low = 0;
    last = std::ceil(1e4 / between) + 1;
    if (!reaches(last)) {
      return kNever;
    }
    while (last - low > 1 && low + 1 < last) {
      const double middle = std::floor(low + 0.5 * (last - low));
      (reaches(middle) ? last : low) = middle;
    }
  }
  return std::pow(std::pow(last * between, shape) + hazard, 1 / shape);
}

namespace {

constexpr double kDays_per_year = 365.25;

}  // namespace

std::optional<FleetCosts> costs_of(const Fleet& fleet, const PlanRequest& request,
                                   const FleetPlan& plan) {
  if (!fleet.tendons.front().break_cost) {
    return std::nullopt;
  }
  FleetCosts all;
  all.cheapest_risk = {1, 0};
  std::map<std::tuple<double, double, double>, double> cheapest_limits;
  for (std::size_t i = 0; i < fleet.tendons.size(); ++i) {
    const Tendon& tendon = fleet.tendons[i];
    const TendonPlan& planned = plan.tendons[i];
    const TendonCosts costs{*tendon.replacement_cost, *tendon.break_cost};
    const double shape = fleet.models[tendon.model].model.life.weibull_shape;
    const double horizon_h = request.horizon.hours(tendon.hours_per_day);
    const double per_year = tendon.damage_per_h * tendon.hours_per_day * kDays_per_year;
    const auto add = [&](PolicyCosts& policy, double breaks, bool replaced, double limit) {
      const double as_planned = replaced ? 1 - breaks : 0;
      policy.planned += as_planned;
      policy.breaks += breaks;
      policy.cost += as_planned * costs.replacement + breaks * costs.of_break;
      policy.cost_per_year += per_year * cost_per_damage(shape, limit, costs);
    };
    add(all.run_to_break, planned.risk, false, std::numeric_limits<double>::infinity());
    constexpr double kB10 = 0.1;
    add(all.at_b10, planned.risk_until_b10, planned.b10.hours <= horizon_h,
        reference::weibull_life_damage(kB10, shape));
    add(all.on_condition, planned.due ? request.risk : planned.risk, planned.due,
        limit_on_condition(shape, tendon.damage_per_h * horizon_h, request.risk));
    const auto [known, is_new] =
        cheapest_limits.try_emplace(std::tuple(shape, costs.replacement, costs.of_break), 0);
    if (is_new) {
      known->second = cheapest_limit(shape, costs);
    }
    const double cheapest = known->second;
    const double risk = -std::expm1(-std::pow(cheapest, shape));
    all.cheapest_per_year += per_year * cost_per_damage(shape, cheapest, costs);
    all.cheapest_risk = {std::min(all.cheapest_risk.least, risk),
                         std::max(all.cheapest_risk.most, risk)};
  }
  return all;
}

}  // namespace host_sim::fleet
