#include "host_sim/report/replay/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <vector>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/replay/captions.hpp"
#include "host_sim/report/replay/flags.hpp"
#include "host_sim/report/replay/plot_builders.hpp"

namespace host_sim::tables {
namespace {

constexpr int kTableDigits = 6;

std::string span_text(double start, double step) {
  return fmt::format("{} to {}", number_text(start, 4), number_text(start + step, 4));
}

std::string relative_difference(double ours, double reference) {
  if (reference == 0) {
    return ours == 0 ? "0" : "not defined";
  }
  return number_text((ours - reference) / reference);
}

}  // namespace

std::string key_numbers(const ReplayReport& report) {
  Table table("Key numbers", {"Quantity", "Value"});
  const auto number = [&table](std::string_view name, double value, std::string_view unit = "") {
    table.row(name, {quantity_text(value, unit, kTableDigits)});
  };
  table.row("Samples", {count_text(report.samples)});
  number("Duration", report.duration_s, "s");
  table.row("Closed cycles", {count_text(report.cycles.closed)});
  table.row("Open half cycles", {count_text(report.cycles.open_half)});
  number("Damage of closed cycles", report.damage.closed);
  number("Damage of open half cycles", report.damage.open);
  number("Damage in total", report.damage.total);
  number("Relative error against the reference", report.relative_error);
  number("Equivalent effective tension", report.equivalent_effective_tension_N, "N");
  number("Probability of surviving one pass", report.survival_probability);
  number("Repeats until 10 % have broken (B10)", report.repeats_to.B10);
  number("Repeats until 50 % have broken (B50)", report.repeats_to.B50);
  number("Mean life in repeats", report.repeats_to.mean);
  number("Repeats until 90 % have broken (B90)", report.repeats_to.B90);
  return table.html();
}

std::string worst_classes(const RangeMeanMatrix& matrix) {
  constexpr std::size_t kShown = 10;
  std::vector<std::size_t> classes(matrix.count.size());
  std::iota(classes.begin(), classes.end(), std::size_t{0});
  std::erase_if(classes, [&matrix](std::size_t i) { return !(matrix.count[i] > 0); });
  const auto shown = static_cast<std::ptrdiff_t>(std::min(kShown, classes.size()));
  std::partial_sort(
      classes.begin(), classes.begin() + shown, classes.end(),
      [&matrix](std::size_t a, std::size_t b) {
        return matrix.damage[a] != matrix.damage[b] ? matrix.damage[a] > matrix.damage[b] : a < b;
      });
  const double total = std::accumulate(matrix.damage.begin(), matrix.damage.end(), 0.0);

  Table table("Classes that do the most damage",
              {"Range, N", "Mean, N", "Cycles", "Damage", "Share of the damage"});
  for (auto it = classes.begin(); it != classes.begin() + shown; ++it) {
    const std::size_t range_class = *it / matrix.means;
    const auto range = static_cast<double>(range_class);
    const auto mean = static_cast<double>(*it % matrix.means);
    table.row(span_text(range * matrix.range_step_N, matrix.range_step_N),
              {span_text(matrix.mean_min_N + mean * matrix.mean_step_N, matrix.mean_step_N),
               number_text(matrix.count[*it], kTableDigits), number_text(matrix.damage[*it]),
               total > 0 ? percent_text(matrix.damage[*it] / total) : std::string("none")});
  }
  return table.html();
}

std::string reference(const ReplayReport& report) {
  Table table("Damage against the reference",
              {"Damage", "Estimator", "Reference", "Relative difference"});
  const auto row = [&table](std::string_view name, double ours, double exact) {
    table.row(name, {number_text(ours, kTableDigits), number_text(exact, kTableDigits),
                     relative_difference(ours, exact)});
  };
  row("Closed cycles", report.damage.closed, report.reference_damage.closed);
  row("Open half cycles", report.damage.open, report.reference_damage.open);
  row("Total", report.damage.total, report.reference_damage.total);
  return table.html();
}

std::string constants(const ReplayReport& report) {
  Table table("Constants of the model", {"Constant", "Value"});
  for (const ModelConstant& constant : report.model_constants) {
    table.row(constant.name, {quantity_text(constant.value, constant.unit, kTableDigits)});
  }
  return table.html();
}

}  // namespace host_sim::tables

namespace host_sim::sections {
namespace {

using elements::chart_place;
using elements::empty;
using elements::tile;

std::string repeats_tile(std::string_view name, double repeats, double duration_s) {
  const double life_s = repeats * duration_s;
  const std::string note =
      std::isfinite(life_s) ? duration_text(life_s) + " of this profile" : "no damage to count";
  return tile(name, number_text(repeats), note);
}

}  // namespace

std::string tiles(const ReplayReport& report) {
  const RepeatsTo& to = report.repeats_to;
  const double of_ultimate = report.equivalent_effective_tension_N / report.ultimate_tension_N;
  std::string html;
  html += tile("Life used by one pass", number_text(report.damage.total),
               "damage; 1 is the characteristic life");
  html += repeats_tile("Repeats to B10 (10\u00a0% broken)", to.B10, report.duration_s);
  html += repeats_tile("Repeats to B50 (half broken)", to.B50, report.duration_s);
  html += repeats_tile("Mean life in repeats", to.mean, report.duration_s);
  html += repeats_tile("Repeats to B90 (90\u00a0% broken)", to.B90, report.duration_s);
  html += tile("Survive one pass", percent_text(report.survival_probability), "of wires");
  html += tile("Equivalent effective tension",
               quantity_text(report.equivalent_effective_tension_N, "N"),
               std::isfinite(of_ultimate) ? percent_text(of_ultimate) + " of the ultimate tension"
                                          : "no cycle to compare");
  html += tile("Cycles counted", counted_text(report.cycles.closed, "cycle"),
               "closed, and " + counted_text(report.cycles.open_half, "half cycle") + " open");
  html += tile("Error against the reference", number_text(report.relative_error, 2),
               "relative, of the total damage");
  html += tile("Length of the profile", duration_text(report.duration_s),
               counted_text(report.samples, "sample"));
  return html;
}

std::string flags(const ReplayReport& report) {
  if (report.flags.empty() && report.warnings.empty()) {
    return "<p class=\"clear\">None: every sample was in range and every cycle was counted "
           "exactly.</p>\n";
  }
  std::string html = "<ul class=\"flags\">\n";
  for (const std::string& flag : report.flags) {
    const FlagText text = flag_text(flag);
    html += fmt::format("<li><strong>{}.</strong> {}</li>\n", html_escape(text.title),
                        html_escape(text.meaning));
  }
  for (const std::string& warning : report.warnings) {
    html += fmt::format("<li>{}</li>\n", html_escape(warning));
  }
  return html + "</ul>\n";
}

std::string wire_tiles(const ReplayReport& report) {
  std::string html = tile("Highest tension", percent_text(report.peak_ratio),
                          "of the ultimate one, " +
                              quantity_text(report.peak_ratio * report.ultimate_tension_N, "N", 4));
  constexpr std::array kLevels_percent = {50, 70, 90};
  for (std::size_t i = 0; i < kLevels_percent.size(); ++i) {
    html += tile(fmt::format("Above {}\u00a0%", kLevels_percent[i]), count_text(report.above[i]),
                 report.above[i] == 1 ? "excursion" : "excursions");
  }
  html += report.minimum_tension_N > 0
              ? tile("Below the minimum", duration_text(report.below_minimum_s),
                     "under " + quantity_text(report.minimum_tension_N, "N"))
              : tile("Below the minimum", "not watched", "the minimum is 0");
  constexpr std::string_view kNoMotion = "the profile tells no motion";
  html += report.motion ? tile("Hung loose", count_text(report.slack_events),
                               report.slack_events == 1 ? "time" : "times")
                        : tile("Hung loose", "not watched", kNoMotion);
  html += report.motion ? tile("Wire", report.broken ? "broken" : "whole",
                               report.broken ? "friction alone was left" : "at the end")
                        : tile("Wire", "not watched", kNoMotion);
  return html;
}

std::string tension_chart(const ReplayReport& report) {
  if (report.tension.time_s.empty()) {
    return empty("There is no sample to draw.");
  }
  return chart_place("tension", "Input tension over time with turning points",
                     captions::tension(report));
}

std::string range_mean_chart(const ReplayReport& report) {
  const std::vector<double>& count = report.range_mean.count;
  if (std::none_of(count.begin(), count.end(), [](double n) { return n > 0; })) {
    return empty("No cycle was counted.");
  }
  return fmt::format(
      "<div class=\"chart heat\" data-chart=\"matrix\">\n"
      "<fieldset class=\"switch\"><legend>Colour by&nbsp;</legend>"
      "<label><input type=\"radio\" name=\"quantity\" value=\"count\" checked> cycles</label>"
      "<label><input type=\"radio\" name=\"quantity\" value=\"damage\"> damage</label></fieldset>\n"
      "<svg tabindex=\"0\" role=\"img\" aria-label=\"Heat map of the range-mean matrix; the table "
      "below lists its most damaging classes\" aria-describedby=\"matrix-readout\">"
      "</svg>\n<p class=\"readout\" id=\"matrix-readout\" aria-live=\"polite\">Point at a class to "
      "read it; by keyboard, the arrows move from class to class.</p>\n</div>\n"
      "<details><summary>Classes that do the most damage</summary>\n{}</details>\n",
      tables::worst_classes(report.range_mean));
}

std::string trajectory_chart(const ReplayReport& report) {
  if (report.trajectory.time_s.empty()) {
    return empty("There is no reading to draw.");
  }
  return chart_place("trajectory", "Damage over time", captions::trajectory(report));
}

std::string life_chart(const ReplayReport& report) {
  if (life_curve(report.damage.total, report.weibull_shape).repeats.empty()) {
    return empty("Without damage there is no end of life to show.");
  }
  return chart_place(
      "life", "Share of broken wires over repeats of this profile",
      fmt::format("B10 {}, B50 {}, mean {}, B90 {} repeats.", number_text(report.repeats_to.B10),
                  number_text(report.repeats_to.B50), number_text(report.repeats_to.mean),
                  number_text(report.repeats_to.B90)));
}

}  // namespace host_sim::sections
