#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host_sim/fleet/break_risk.hpp"
#include "host_sim/fleet/demand.hpp"
#include "host_sim/fleet/fleet_table.hpp"
#include "host_sim/fleet/horizon.hpp"

namespace host_sim::fleet {

struct PlanRequest {
  Date today;
  Horizon horizon;
  double service = 0.95;  ///< probability that the spares are enough, in 0 .. 1
  double risk = 0.1;      ///< of a break between today and the date to replace, in 0 .. 1
  unsigned threads = 0;   ///< 0: all cores; nothing depends on it
};

/// When something is reached.
struct Due {
  double hours = 0;          ///< of operation from today; below 0 where it is over
  std::optional<Date> date;  ///< the last whole day before it; none beyond 100 years
};

/// What is planned for one tendon.
struct TendonPlan {
  double risk = 0;            ///< of a break within the horizon, given that it is whole today
  double risk_at_fit = 0;     ///< the same with the law and the rate as they are fitted
  Due replace;                ///< when the risk since today is PlanRequest::risk
  Due b10;                    ///< B10 of the whole life, by the law as it is fitted
  double risk_until_b10 = 0;  ///< of a break before that and within the horizon
  bool due = false;           ///< to be replaced within the horizon
  double evidence = 1;        ///< risk over what it would be if survival so far told nothing
};

/// How many spares it takes until the horizon.
struct Spares {
  Demand demand;
  std::size_t count = 0;  ///< enough with at least the probability asked for
  double service = 0;     ///< with which they are
};

/// What a policy costs, expected.
struct PolicyCosts {
  double planned = 0;        ///< replacements as planned until the horizon
  double breaks = 0;         ///< until then, each with the replacement after it
  double cost = 0;           ///< of both
  double cost_per_year = 0;  ///< in the long run, as new wires follow each other
};

/// The law is as it is fitted in the long run.
struct FleetCosts {
  PolicyCosts run_to_break;
  PolicyCosts at_b10;        ///< of the whole life, at once where that is past
  PolicyCosts on_condition;  ///< planned anew at each horizon
  double cheapest_per_year = 0;
  /// Share of new wires that would break before the damage that it is cheapest to replace them at:
  /// the least and the most of all tendons; 1 where no replacement pays.
  struct {
    double least = 0;
    double most = 0;
  } cheapest_risk;
};

struct FleetPlan {
  std::vector<TendonPlan> tendons;  ///< in the order of the fleet
  Spares breaks;                    ///< where nothing is replaced before it breaks
  Spares on_condition;              ///< where each tendon that is due is replaced on its date
  std::size_t due = 0;
  std::size_t past_b10 = 0;
  double expected_breaks = 0;   ///< where nothing is replaced before it breaks
  double breaks_until_due = 0;  ///< expected where each tendon that is due is replaced on its date
  double second_breaks_at_most = 0;  ///< expected breaks of replacements, which are left out
  std::optional<FleetCosts> costs;   ///< where the tendons have costs
  std::vector<std::string> warnings;
};

/// The law of a model with what `[life.interval]` says of it; exact where it says nothing.
LawBelief belief_of(const Model::Life& life);

/// @throws Interruption
FleetPlan make_plan(const Fleet& fleet, const PlanRequest& request);

/// The spares that are enough until a part of the horizon.
struct SparesUntil {
  double length = 0;  ///< of the horizon, in its unit
  Spares breaks;
  Spares on_condition;
};

/// From today to the horizon, whose plan is `plan`, in even steps: fewer for a large fleet.
/// @throws Interruption
std::vector<SparesUntil> course_of(const Fleet& fleet, const PlanRequest& request,
                                   const FleetPlan& plan);

/// Tendons by urgency: the date to replace, then the risk, then the order of the fleet.
std::vector<std::size_t> by_urgency(const FleetPlan& plan);

/// The policies by their names.
std::array<std::pair<std::string_view, const PolicyCosts*>, 3> policies_of(const FleetCosts& costs);

/// What risk it is cheapest to replace at, for people.
std::string cheapest_sentence(const FleetCosts& costs);

/// For people. @param source what stands for the fleet
void write_plan(std::ostream& out, std::string_view source, const Fleet& fleet,
                const PlanRequest& request, const FleetPlan& plan);

/// As one JSON object.
std::string plan_json(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan);

/// As a calendar (RFC 5545): an event of one day for each tendon that is due within the horizon,
/// and one at the horizon. An event of a tendon has the same UID in every plan.
std::string plan_calendar(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan);

/// As a table with a row for each tendon, in the order of the fleet.
std::string plan_table(const Fleet& fleet, const FleetPlan& plan);

}  // namespace host_sim::fleet
