#pragma once

#include <optional>
#include <string_view>

#include "host_sim/fleet/fleet_plan.hpp"

namespace host_sim::fleet {

/// Of one tendon, in whatever unit both have.
struct TendonCosts {
  double replacement = 0;  ///< planned
  double of_break = 0;     ///< with the replacement after it; at least that of a planned one
};

/// Gives each tendon that has no costs of its own those of all. Where there are none at all, it
/// leaves the fleet as it is.
/// @param source stands for the fleet in errors
/// @throws InputError where one has no costs and another has, or a break costs less than a
/// replacement
void set_costs(Fleet& fleet, std::optional<double> replacement, std::optional<double> of_break,
               std::string_view source);

// Age replacement in the long run: a new wire follows each one, which is replaced at the damage
// `limit` if it is whole then (infinity: never), and when it breaks. Barlow and Proschan, 1965.

/// Mean damage of a wire when it is replaced: the integral of R over 0 .. limit.
double mean_damage(double shape, double limit);

/// Mean cost of a wire over its mean damage.
double cost_per_damage(double shape, double limit, const TendonCosts& costs);

/// The limit with the least cost; infinity where no replacement pays. It solves
/// beta T^(beta-1) mean_damage(T) - F(T) = replacement / (of_break - replacement).
double cheapest_limit(double shape, const TendonCosts& costs);

/// The damage at which a wire is replaced on condition, if it is planned for when it is new, and
/// again whenever it has got `between` more: in the first of these spans in which the risk of a
/// break reaches `risk`, when it does. Infinity where it never does.
double limit_on_condition(double shape, double between, double risk);

/// What the policies cost. Empty where tendons have no costs.
std::optional<FleetCosts> costs_of(const Fleet& fleet, const PlanRequest& request,
                                   const FleetPlan& plan);

}  // namespace host_sim::fleet
