#include "host_sim/report/fleet/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>

#include "host_sim/report/page/chart.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"

/// Files of the page of a fleet, embedded when the program is built.
namespace host_sim::fleet_page_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::fleet_page_assets

namespace host_sim {
namespace {

using fleet::Fleet;
using fleet::FleetPlan;
using fleet::Horizon;
using fleet::PlanRequest;
using fleet::SparesUntil;
using fleet::Tendon;
using fleet::TendonPlan;

constexpr std::size_t kMostRows = 50;
constexpr std::size_t kMostPoints = 2000;

std::string date_or_none(const fleet::Due& due) {
  return due.date ? fleet::date_text(*due.date) : "none";
}

std::string length_text(const Horizon& horizon, double length) {
  return horizon.kind == Horizon::Kind::calendar ? quantity_text(length, "days", 4)
                                                 : quantity_text(length, "hours of operation", 4);
}

std::string fleet_verdict(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan) {
  const std::string spares = fmt::format(
      "{} with {}.", plan.on_condition.count == 1 ? "spare is enough" : "spares are enough",
      percent_text(plan.on_condition.service));
  return fmt::format("{} of {} to replace within {}; {} {}", count_text(plan.due),
                     counted_text(fleet.tendons.size(), "tendon"),
                     length_text(request.horizon, request.horizon.length),
                     count_text(plan.on_condition.count), spares);
}

std::string tiles(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan) {
  using elements::tile;
  const std::string enough = "enough with " + percent_text(request.service);
  std::string html = tile("To replace", count_text(plan.due), "until the horizon") +
                     tile("Past B10", count_text(plan.past_b10), "today") +
                     tile("Spares on condition", count_text(plan.on_condition.count), enough) +
                     tile("Spares run to break", count_text(plan.breaks.count), enough) +
                     tile("Breaks on condition", number_text(plan.breaks_until_due), "expected") +
                     tile("Breaks run to break", number_text(plan.expected_breaks), "expected");
  if (!fleet.broken.empty()) {
    html += tile("Broken", count_text(fleet.broken.size()), "to replace now");
  }
  return html;
}

std::string broken_words(const Fleet& fleet) {
  if (fleet.broken.empty()) {
    return "";
  }
  std::string names;
  for (const std::string& name : fleet.broken) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return fmt::format("<p>Broken, to be replaced now, and in no number here: {}.</p>\n",
                     html_escape(names));
}

std::string rest_words(std::size_t rows, std::size_t all) {
  return rows < all ? fmt::format(
                          "<p class=\"caption\">And {} less urgent, all in the table that --table "
                          "writes.</p>\n",
                          count_text(all - rows))
                    : "";
}

std::string due_table(const Fleet& fleet, const FleetPlan& plan,
                      const std::vector<std::size_t>& order) {
  Table table("Tendons to replace", {"Tendon", "Replace on", "Damage", "Risk until the horizon",
                                     "B10 of the whole life"});
  std::size_t rows = 0;
  for (const std::size_t i : order) {
    const TendonPlan& planned = plan.tendons[i];
    if (planned.due && rows < kMostRows) {
      ++rows;
      table.row(fleet.tendons[i].name,
                {date_or_none(planned.replace), fmt::format("{:.4f}", fleet.tendons[i].damage),
                 percent_text(planned.risk), date_or_none(planned.b10)});
    }
  }
  return elements::table_or(rows > 0, table.html(),
                            "No tendon is to be replaced until the horizon.") +
         rest_words(rows, plan.due);
}

Layer course_line(std::string name, std::string colour, bool dashed) {
  Layer layer;
  layer.name = std::move(name);
  layer.colour = std::move(colour);
  layer.dashed = dashed;
  return layer;
}

Chart spares_chart(const PlanRequest& request, const std::vector<SparesUntil>& course) {
  const bool calendar = request.horizon.kind == Horizon::Kind::calendar;
  Chart chart;
  chart.id = "spares";
  chart.name = "Replacements until the horizon";
  chart.x = {calendar ? "Days from " + fleet::date_text(request.today) : "Hours of operation",
             Axis::Kind::linear,
             calendar ? "d" : "h",
             {},
             true};
  chart.y = {"Tendons", Axis::Kind::linear, "", {}, true};
  const std::string enough = ", enough with " + percent_text(request.service);
  Layer condition = course_line("On condition" + enough, "line", false);
  Layer condition_mean = course_line("On condition, expected", "line", true);
  Layer breaks = course_line("Run to break" + enough, "mark", false);
  Layer breaks_mean = course_line("Run to break, expected", "mark", true);
  for (const SparesUntil& until : course) {
    for (Layer* const layer : {&condition, &condition_mean, &breaks, &breaks_mean}) {
      layer->x.push_back(until.length);
    }
    condition.y.push_back(static_cast<double>(until.on_condition.count));
    condition_mean.y.push_back(until.on_condition.demand.mean());
    breaks.y.push_back(static_cast<double>(until.breaks.count));
    breaks_mean.y.push_back(until.breaks.demand.mean());
  }
  chart.layers = {condition, condition_mean, breaks, breaks_mean};
  return chart;
}

std::string spares_table(const PlanRequest& request, const std::vector<SparesUntil>& course) {
  Table table("Replacements until the horizon",
              {"Until", "Spares on condition", "Expected", "Spares run to break", "Expected"});
  for (const SparesUntil& until : course) {
    table.row(length_text(request.horizon, until.length),
              {count_text(until.on_condition.count), number_text(until.on_condition.demand.mean()),
               count_text(until.breaks.count), number_text(until.breaks.demand.mean())});
  }
  return table.html();
}

Chart risk_chart(const Fleet& fleet, const PlanRequest& request, const FleetPlan& plan,
                 const std::vector<std::size_t>& order) {
  Chart chart;
  chart.id = "risk";
  chart.name = "Risk of each tendon";
  chart.x = {"Damage", Axis::Kind::linear, "", {}, true};
  chart.y = {"Risk of a break until the horizon, %", Axis::Kind::linear, "%", {}, true};
  Layer due;
  due.kind = Layer::Kind::points;
  due.name = "To replace";
  due.colour = "mark";
  due.shape = "diamond";
  Layer later = due;
  later.name = "Later";
  later.colour = "line";
  later.shape = "circle";
  constexpr double kPercent = 100;
  double most_damage = 0;
  for (std::size_t k = 0; k < std::min(order.size(), kMostPoints); ++k) {
    const Tendon& tendon = fleet.tendons[order[k]];
    const TendonPlan& planned = plan.tendons[order[k]];
    Layer& layer = planned.due ? due : later;
    layer.x.push_back(tendon.damage);
    layer.y.push_back(kPercent * planned.risk);
    layer.texts.push_back(fmt::format("{}: damage {:.4f}, risk {}", tendon.name, tendon.damage,
                                      percent_text(planned.risk)));
    most_damage = std::max(most_damage, tendon.damage);
  }
  Layer limit = course_line("Replaced at " + percent_text(request.risk), "ink-soft", true);
  limit.x = {0, std::max(most_damage, 0.01)};
  limit.y = {kPercent * request.risk, kPercent * request.risk};
  chart.layers = {limit};
  for (const Layer& layer : {later, due}) {
    if (!layer.x.empty()) {
      chart.layers.push_back(layer);
    }
  }
  return chart;
}

std::string risk_table(const Fleet& fleet, const FleetPlan& plan,
                       const std::vector<std::size_t>& order) {
  Table table("Risk of each tendon", {"Tendon", "Damage", "An hour", "Hours a day", "Risk",
                                      "By the fit alone", "Replace on"});
  const std::size_t rows = std::min(order.size(), kMostRows);
  for (std::size_t k = 0; k < rows; ++k) {
    const Tendon& tendon = fleet.tendons[order[k]];
    const TendonPlan& planned = plan.tendons[order[k]];
    table.row(tendon.name, {fmt::format("{:.4f}", tendon.damage), number_text(tendon.damage_per_h),
                            number_text(tendon.hours_per_day), percent_text(planned.risk),
                            percent_text(planned.risk_at_fit), date_or_none(planned.replace)});
  }
  return table.html() + rest_words(rows, order.size());
}

std::string costs_section(const FleetPlan& plan) {
  if (!plan.costs) {
    return "";
  }
  Table table("What the policies cost",
              {"Policy", "Planned", "Breaks", "Cost until the horizon", "Cost a year, long run"});
  for (const auto& [name, policy] : fleet::policies_of(*plan.costs)) {
    table.row(name, {number_text(policy->planned), number_text(policy->breaks),
                     number_text(policy->cost, 4), number_text(policy->cost_per_year, 4)});
  }
  table.row("at the cheapest", {"", "", "", number_text(plan.costs->cheapest_per_year, 4)});
  return "<section aria-labelledby=\"costs-heading\">\n<h2 id=\"costs-heading\">What the policies "
         "cost</h2>\n<p class=\"caption\">" +
         html_escape(fleet::cheapest_sentence(*plan.costs)) + "</p>\n" + table.html() +
         "</section>\n";
}

}  // namespace

void write_fleet_report(std::ostream& out, std::string_view source, const Fleet& fleet,
                        const PlanRequest& request, const FleetPlan& plan,
                        const std::vector<SparesUntil>& course, std::string_view program_version) {
  const std::vector<std::size_t> order = fleet::by_urgency(plan);
  const Chart spares = spares_chart(request, course);
  const Chart risk = risk_chart(fleet, request, plan, order);
  Slots slots;
  slots["name"] = html_escape(source);
  slots["verdict"] = html_escape(fleet_verdict(fleet, request, plan));
  slots["origin"] = html_escape(fmt::format(
      "From {}, for {}. A tendon is replaced when the risk of a break since then is {}.",
      fleet::date_text(request.today), length_text(request.horizon, request.horizon.length),
      percent_text(request.risk)));
  slots["tiles"] = tiles(fleet, request, plan);
  slots["warnings"] = elements::warnings(plan.warnings);
  slots["broken"] = broken_words(fleet);
  slots["due"] = due_table(fleet, plan, order);
  slots["spares"] =
      elements::chart(spares,
                      "How many tendons are replaced by then: on condition, each that is due on "
                      "its date, or run to "
                      "break. The solid line is what is enough with the probability asked for.",
                      "");
  slots["spares_table"] = spares_table(request, course);
  slots["risk"] = elements::chart(risk,
                                  "Each point is a tendon that is whole today; beside its damage, "
                                  "its risk hangs on its rate and "
                                  "hours, and on how sure both and the law are.",
                                  "");
  slots["risk_table"] = risk_table(fleet, plan, order);
  slots["costs"] = costs_section(plan);
  std::ostringstream body;
  fill_template(body, fleet_page_assets::body_html, slots);
  write_page(out, {"Tendon life: fleet",
                   body.str(),
                   fmt::format("Made by host_sim {}.", program_version),
                   {{"charts", {{"spares", chart_json(spares)}, {"risk", chart_json(risk)}}}},
                   fleet_page_assets::draw_js});
}

}  // namespace host_sim
