#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hal/files/csv.hpp"
#include "hal/files/text.hpp"
#include "host_sim/fleet/fleet_plan.hpp"
#include "host_sim/io/json.hpp"

namespace host_sim::fleet {

using hal::files::printable;

namespace {

using nlohmann::ordered_json;

std::string date_or(const Due& due, std::string_view none) {
  return due.date ? date_text(*due.date) : std::string(none);
}

ordered_json due_json(const Due& due) {
  return {{"hours", json_number(due.hours)},
          {"date", due.date ? ordered_json(date_text(*due.date)) : ordered_json(nullptr)}};
}

ordered_json spares_json(const Spares& spares) {
  ordered_json demand = ordered_json::array();
  for (std::size_t i = 0; i < spares.demand.probability.size(); ++i) {
    demand.push_back({spares.demand.first + i, spares.demand.probability[i]});
  }
  return {{"count", spares.count},
          {"service", spares.service},
          {"expected", spares.demand.mean()},
          {"demand", demand}};
}

ordered_json policy_json(const PolicyCosts& policy) {
  return {{"planned", policy.planned},
          {"breaks", policy.breaks},
          {"cost", policy.cost},
          {"cost_per_year", policy.cost_per_year}};
}

ordered_json costs_json(const FleetCosts& costs) {
  return {{"run_to_break", policy_json(costs.run_to_break)},
          {"at_b10", policy_json(costs.at_b10)},
          {"on_condition", policy_json(costs.on_condition)},
          {"cheapest",
           {{"risk_least", costs.cheapest_risk.least},
            {"risk_most", costs.cheapest_risk.most},
            {"cost_per_year", costs.cheapest_per_year}}}};
}

std::vector<std::string> printable_names(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  result.reserve(names.size());
  for (const std::string& name : names) {
    result.push_back(printable(name));
  }
  return result;
}

}  // namespace

std::string plan_json(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan) {
  ordered_json json{{"today", date_text(request.today)},
                    {"horizon", request.horizon.text},
                    {request.horizon.kind == Horizon::Kind::calendar ? "horizon_days" : "horizon_h",
                     request.horizon.length},
                    {"service", request.service},
                    {"risk", request.risk},
                    {"due", plan.due},
                    {"past_b10", plan.past_b10},
                    {"broken", printable_names(fleet.broken)},
                    {"expected_breaks", plan.expected_breaks},
                    {"expected_breaks_until_due", plan.breaks_until_due},
                    {"second_breaks_at_most", plan.second_breaks_at_most},
                    {"spares",
                     {{"run_to_break", spares_json(plan.breaks)},
                      {"on_condition", spares_json(plan.on_condition)}}},
                    {"costs", plan.costs ? costs_json(*plan.costs) : ordered_json(nullptr)},
                    {"warnings", plan.warnings}};
  ordered_json tendons = ordered_json::array();
  for (std::size_t i = 0; i < fleet.tendons.size(); ++i) {
    const Tendon& tendon = fleet.tendons[i];
    const TendonPlan& planned = plan.tendons[i];
    tendons.push_back({{"tendon", printable(tendon.name)},
                       {"model", printable(fleet.models[tendon.model].file)},
                       {"damage", tendon.damage},
                       {"damage_per_h", tendon.damage_per_h},
                       {"rate_log_sd", tendon.rate_log_sd},
                       {"hours_per_day", tendon.hours_per_day},
                       {"risk", planned.risk},
                       {"risk_at_fit", planned.risk_at_fit},
                       {"due", planned.due},
                       {"replace", due_json(planned.replace)},
                       {"b10", due_json(planned.b10)}});
  }
  json["tendons"] = std::move(tendons);
  return json.dump(2) + "\n";
}

std::string plan_table(const Fleet& fleet, const FleetPlan& plan) {
  constexpr std::array<std::string_view, 11> kColumns{
      "tendon", "model",      "damage",       "damage_per_h", "risk",    "risk_at_fit",
      "due",    "replace_on", "replace_in_h", "b10_on",       "b10_in_h"};
  std::string table = hal::files::csv_head(kColumns);
  for (std::size_t i = 0; i < fleet.tendons.size(); ++i) {
    const Tendon& tendon = fleet.tendons[i];
    const TendonPlan& planned = plan.tendons[i];
    hal::files::CsvRow row;
    row.add(tendon.name);
    row.add(fleet.models[tendon.model].file);
    row.add(tendon.damage);
    row.add(tendon.damage_per_h);
    row.add(planned.risk);
    row.add(planned.risk_at_fit);
    row.add(planned.due ? "yes" : "no");
    row.add(date_or(planned.replace, ""));
    row.add(planned.replace.hours);
    row.add(date_or(planned.b10, ""));
    row.add(planned.b10.hours);
    table += row.line();
  }
  return table;
}

namespace {

std::string percent(double share) {
  return share > 0 && share < 5e-5 ? "<0.01 %" : fmt::format("{:.2f} %", 100 * share);
}

void write_tendons(std::ostream& out, const Fleet& fleet, const FleetPlan& plan) {
  constexpr std::size_t kMostRows = 20;
  const std::vector<std::size_t> order = by_urgency(plan);
  const std::size_t rows = std::min(order.size(), kMostRows);
  std::size_t width = std::string_view("TENDON").size();
  for (std::size_t k = 0; k < rows; ++k) {
    width =
        std::max(width, hal::files::character_count(printable(fleet.tendons[order[k]].name, 40)));
  }
  fmt::print(out, "\n{:<{}}  {:>8}  {:>9}  {:>10}  {:>10}\n", "TENDON", width, "DAMAGE", "RISK",
             "REPLACE", "B10");
  for (std::size_t k = 0; k < rows; ++k) {
    const Tendon& tendon = fleet.tendons[order[k]];
    const TendonPlan& planned = plan.tendons[order[k]];
    fmt::print(out, "{:<{}}  {:>8.4f}  {:>9}  {:>10}  {:>10}\n", printable(tendon.name, 40), width,
               tendon.damage, percent(planned.risk), date_or(planned.replace, "none"),
               date_or(planned.b10, "none"));
  }
  if (rows < order.size()) {
    fmt::print(out, "and {} less urgent\n", order.size() - rows);
  }
}

void write_spares(std::ostream& out, std::string_view name, const Spares& spares) {
  fmt::print(out, "  {:<16} {} spares, enough with {}; {:.2f} expected\n", name, spares.count,
             percent(spares.service), spares.demand.mean());
}

void write_costs(std::ostream& out, const FleetCosts& costs) {
  fmt::print(out, "\n{:<16}  {:>8}  {:>8}  {:>12}  {:>12}\n", "COST", "PLANNED", "BREAKS",
             "UNTIL THEN", "PER YEAR");
  for (const auto& [name, policy] : policies_of(costs)) {
    fmt::print(out, "{:<16}  {:>8.2f}  {:>8.2f}  {:>12.6g}  {:>12.6g}\n", name, policy->planned,
               policy->breaks, policy->cost, policy->cost_per_year);
  }
  fmt::print(out, "{:<16}  {:>8}  {:>8}  {:>12}  {:>12.6g}\n{}\n", "at the cheapest", "", "", "",
             costs.cheapest_per_year, cheapest_sentence(costs));
}

}  // namespace

std::array<std::pair<std::string_view, const PolicyCosts*>, 3> policies_of(
    const FleetCosts& costs) {
  return {{{"run to break", &costs.run_to_break},
           {"at B10", &costs.at_b10},
           {"on condition", &costs.on_condition}}};
}

std::string cheapest_sentence(const FleetCosts& costs) {
  const auto& [least, most] = costs.cheapest_risk;
  if (least == 1) {
    return "In the long run no replacement before a break pays.";
  }
  constexpr double kOneShare = 1e-6;
  const std::string shares =
      most - least < kOneShare
          ? fmt::format("{:.3g} %", 100 * most)
          : fmt::format("{:.3g} .. {:.3g} %, by the tendon,", 100 * least, 100 * most);
  return fmt::format(
      "In the long run it is cheapest to replace a tendon at the damage before which {} of new "
      "ones "
      "would break.",
      shares);
}

void write_plan(std::ostream& out, std::string_view source, const Fleet& fleet,
                const PlanRequest& request, const FleetPlan& plan) {
  fmt::print(out, "{}: {} tendon{}, horizon {} from {}\n", printable(source), fleet.tendons.size(),
             fleet.tendons.size() == 1 ? "" : "s", request.horizon.text, date_text(request.today));
  fmt::print(out, "  {:<16} {} until the horizon: the risk of a break since today reaches {:g} %\n",
             "to replace", plan.due, 100 * request.risk);
  fmt::print(out, "  {:<16} {} today\n", "past B10", plan.past_b10);
  if (!fleet.broken.empty()) {
    fmt::print(out, "  {:<16} {}, to be replaced now, and in no number here: {}\n", "broken",
               fleet.broken.size(), printable(fmt::format("{}", fmt::join(fleet.broken, ", "))));
  }
  write_spares(out, "run to break", plan.breaks);
  write_spares(out, "on condition", plan.on_condition);
  fmt::print(out,
             "  {:<16} {:.2f} run to break, {:.2f} on condition; breaks of replacements, at most "
             "{:.2g} more, are left out\n",
             "expected breaks", plan.expected_breaks, plan.breaks_until_due,
             plan.second_breaks_at_most);
  if (plan.costs) {
    write_costs(out, *plan.costs);
  }
  write_tendons(out, fleet, plan);
  for (const std::string& warning : plan.warnings) {
    fmt::print(out, "warning: {}\n", printable(warning));
  }
}

}  // namespace host_sim::fleet
