#include "host_sim/report/replay/given_survival.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/replay/assets.hpp"

namespace host_sim {
namespace {

constexpr double kPercent = 100;

/// A share of risk with the repeats of this wire and of a new one.
struct Mark {
  double risk;
  const Estimate& repeats;
  double repeats_of_new;
};

std::vector<Mark> marks_of(const ReplayReport& report) {
  const GivenSurvival& given = *report.given_survival;
  return {{0.1, given.to_10, report.repeats_to.B10},
          {0.5, given.to_50, report.repeats_to.B50},
          {0.9, given.to_90, report.repeats_to.B90}};
}

bool is_new(const GivenSurvival& given) {
  return given.used == 0;
}

std::string wire_text(const GivenSurvival& given) {
  return is_new(given) ? "A new wire" : "This wire, damage " + number_text(given.used);
}

std::string interval_name(double level) {
  return percent_text(level) + " interval of the fit";
}

std::string profile_time(double repeats, double duration_s) {
  return duration_text(repeats * duration_s);
}

/// Between the lower ends and the upper ones, back along these.
Layer fit_band(const BreakCurve& curve, double level) {
  Layer layer;
  layer.kind = Layer::Kind::area;
  layer.name = interval_name(level);
  const std::size_t size = curve.repeats.size();
  for (std::size_t i = 0; i < 2 * size; ++i) {
    const std::size_t at = i < size ? i : 2 * size - 1 - i;
    const Estimate& broken = curve.broken[at];
    layer.x.push_back(curve.repeats[at]);
    layer.y.push_back(kPercent *
                      (broken.interval ? (*broken.interval)[i < size ? 0 : 1] : broken.value));
  }
  return layer;
}

Layer break_line(const BreakCurve& curve, std::string name) {
  Layer layer;
  layer.name = std::move(name);
  layer.width_px = 2.5;
  layer.x = curve.repeats;
  for (const Estimate& broken : curve.broken) {
    layer.y.push_back(kPercent * broken.value);
  }
  return layer;
}

Layer new_wire_line(const BreakCurve& curve) {
  Layer layer;
  layer.name = "A new wire";
  layer.colour = "ink-soft";
  layer.dashed = true;
  layer.width_px = 1.5;
  layer.x = curve.repeats;
  for (const double broken : curve.broken_new) {
    layer.y.push_back(kPercent * broken);
  }
  return layer;
}

/// The marks of 10, 50 and 90 % and, as a layer of its own, their names.
void add_marks(Chart& chart, const ReplayReport& report) {
  Layer points;
  points.kind = Layer::Kind::points;
  points.name = "10, 50 and 90 %";
  points.colour = "mark";
  Layer labels;
  labels.kind = Layer::Kind::labels;
  labels.colour = "ink";
  for (const Mark& mark : marks_of(report)) {
    points.x.push_back(mark.repeats.value);
    points.y.push_back(kPercent * mark.risk);
    points.texts.push_back(profile_time(mark.repeats.value, report.duration_s) +
                           " of this profile");
    labels.texts.push_back(number_text(mark.repeats.value));
  }
  labels.x = points.x;
  labels.y = points.y;
  chart.layers.push_back(std::move(points));
  chart.layers.push_back(std::move(labels));
}

Layer horizon_mark(const GivenSurvival::Risk& risk) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.name = "The horizon";
  layer.colour = "ink";
  layer.shape = "star";
  layer.x = {risk.repeats};
  layer.y = {kPercent * risk.probability.value};
  layer.texts = {risk.horizon};
  return layer;
}

std::string interval_cell(const Estimate& estimate) {
  return estimate.interval ? fmt::format("{} to {}", number_text((*estimate.interval)[0]),
                                         number_text((*estimate.interval)[1]))
                           : "not known";
}

std::string survivor_table(const ReplayReport& report) {
  const GivenSurvival& given = *report.given_survival;
  const std::string interval = given.level > 0 ? interval_name(given.level) : "Interval of the fit";
  Table table("Life given survival", {"Risk of a break", "Further repeats", interval,
                                      "Time of this profile", "A new wire, repeats"});
  for (const Mark& mark : marks_of(report)) {
    table.row(
        percent_text(mark.risk),
        {number_text(mark.repeats.value, 4), interval_cell(mark.repeats),
         std::isfinite(mark.repeats.value) ? profile_time(mark.repeats.value, report.duration_s)
                                           : number_text(mark.repeats.value),
         number_text(mark.repeats_of_new, 4)});
  }
  return table.html();
}

std::string survivor_caption(const GivenSurvival& given) {
  const std::string who =
      is_new(given) ? std::string("A new wire")
                    : fmt::format("A wire that is whole at damage {}", number_text(given.used));
  const std::string fit =
      given.level > 0
          ? fmt::format("The {} interval is that of the fit; how the load varies is not in it.",
                        percent_text(given.level))
          : std::string("The model does not say how well its life is known: no intervals.");
  const std::string_view beside =
      is_new(given) ? "" : " B10 of the whole life does not know that it has lasted so far.";
  return fmt::format("{}: the probability that it breaks within so many further repeats.{} {}", who,
                     beside, fit);
}

std::string horizon_sentence(const ReplayReport& report) {
  const GivenSurvival& given = *report.given_survival;
  if (!given.risk) {
    return {};
  }
  const GivenSurvival::Risk& risk = *given.risk;
  const bool in_hours = risk.horizon.back() == 'h';
  const std::string within =
      in_hours ? fmt::format("{}, {} repeats", risk.horizon, number_text(risk.repeats))
               : number_text(risk.repeats) + " repeats";
  std::string text = fmt::format("Within {} it breaks with a probability of {}", within,
                                 percent_text(risk.probability.value));
  if (risk.probability.interval) {
    text += fmt::format(" ({} to {})", percent_text((*risk.probability.interval)[0]),
                        percent_text((*risk.probability.interval)[1]));
  }
  if (!is_new(given)) {
    const double damage_of_new = risk.repeats * report.damage.total;
    text += fmt::format(", a new wire with {}",
                        percent_text(-std::expm1(-std::pow(damage_of_new, report.weibull_shape))));
  }
  return text + ".";
}

}  // namespace

Chart break_chart(const ReplayReport& report) {
  Chart chart;
  chart.id = "survivor";
  chart.name = "Risk of a break of a wire that is whole now";
  chart.x = {"Repeats of this profile from now on", Axis::Kind::linear, "repeats", {}, true};
  chart.y = {"Broken wires, %", Axis::Kind::linear, "%", {}, true};
  const BreakCurve& curve = report.break_curve;
  if (!report.given_survival || curve.repeats.empty()) {
    return chart;
  }
  const GivenSurvival& given = *report.given_survival;
  if (given.level > 0) {
    chart.layers.push_back(fit_band(curve, given.level));
  }
  if (!is_new(given)) {
    chart.layers.push_back(new_wire_line(curve));
  }
  chart.layers.push_back(break_line(curve, wire_text(given)));
  add_marks(chart, report);
  if (given.risk && given.risk->repeats <= curve.repeats.back()) {
    chart.layers.push_back(horizon_mark(*given.risk));
  }
  return chart;
}

}  // namespace host_sim

namespace host_sim::sections {

std::string given_survival(const ReplayReport& report) {
  if (!report.given_survival) {
    return {};
  }
  const Chart chart = break_chart(report);
  const std::string horizon = horizon_sentence(report);
  const Slots slots = {
      {"caption", html_escape(survivor_caption(*report.given_survival))},
      {"horizon",
       horizon.empty() ? horizon : "<p class=\"lead\">" + html_escape(horizon) + "</p>\n"},
      {"chart", chart.layers.empty()
                    ? elements::empty("Without damage there is no break to expect.")
                    : elements::chart_place(chart.id, chart.name, horizon)},
      {"table", survivor_table(report)},
  };
  std::ostringstream html;
  fill_template(html, replay_assets::given_survival_html, slots);
  return html.str();
}

}  // namespace host_sim::sections
