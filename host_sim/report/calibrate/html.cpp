#include "host_sim/report/calibrate/html.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <string_view>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/notation.hpp"
#include "host_sim/report/calibrate/sentences.hpp"
#include "host_sim/report/calibrate/tables.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"

/// Files of the page of a calibration, embedded when the program is built.
namespace host_sim::calibrate_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::calibrate_assets

/// Parts of the page as HTML with all texts escaped.
namespace host_sim::calibrate_page::sections {
namespace {

using elements::chart;
using elements::table_or;
using elements::tile;
using elements::warnings;
using elements::words;

std::string probability_caption(const calibrate::LevelResult& level) {
  if (!has_fit(level)) {
    return fmt::format("No Weibull line: {}.", calibrate::problem_name(level.weibull().problem));
  }
  const statistics::Distribution& weibull = level.weibull().distribution;
  return fmt::format("Shape {}, scale {} cycles; the band holds each life with 95\u00a0%.",
                     number_text(weibull.second), number_text(weibull.first));
}

std::string law_tiles(const calibrate::StressLife& law) {
  return tile("Exponent gamma", number_text(law.law.exponent, 4),
              "95\u00a0%: " + interval_text(law.exponent_ci95, 3)) +
         tile("Scale A", number_text(law.law.scale),
              "95\u00a0%: " + interval_text(law.scale_ci95, 3)) +
         tile("Weibull shape beta", number_text(law.law.shape),
              "95\u00a0%: " + interval_text(law.shape_ci95, 3));
}

std::string tiles(const calibrate::CalibrateResult& result) {
  std::string html = result.stress_life
                         ? law_tiles(*result.stress_life)
                         : tile("Life law", "none", "it could not be fitted: see the warnings");
  if (result.common_shape) {
    html +=
        tile("p of one shape", p_text(calibrate::p_of(result.common_shape->homogeneity)),
             calibrate::rejected(result.common_shape->homogeneity) ? "rejected at 5\u00a0%"
                                                                   : "not rejected at 5\u00a0%");
  }
  for (const calibrate::UseLevel& use : result.use_levels) {
    html += tile("Mean life, " + use.name, number_text(use.mean) + " cycles",
                 "95\u00a0%: " + interval_text(use.mean_ci95, 3));
  }
  html += tile("Specimens", count_text(result.specimens),
               fmt::format("{} failed, {} suspended", result.failed, result.suspended));
  return html;
}

/// A probability plot with its tables for each level.
std::string probability_plots(const calibrate::CalibrateResult& result) {
  std::string html;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const calibrate::LevelResult& level = result.levels[i];
    html += "<div>\n" + chart(probability_chart(result, i), probability_caption(level),
                              title_of(level) + " has no failure to show.");
    html += fmt::format("<details><summary>{} as tables</summary>\n{}{}</details>\n</div>\n",
                        html_escape(title_of(level)), tables::positions(level),
                        level.band.p.empty() ? "" : tables::band(level));
  }
  return html;
}

}  // namespace
}  // namespace host_sim::calibrate_page::sections

namespace host_sim {
namespace {

using calibrate::CalibrateResult;
using calibrate_page::StressLifeAxes;
namespace captions = calibrate_page::captions;
namespace sections = calibrate_page::sections;
namespace tables = calibrate_page::tables;

constexpr std::string_view kNoFit = "No level has a Weibull fit.";
constexpr std::string_view kNoFailure = "No specimen failed.";

void add_head(Slots& slots, const CalibrateResult& result) {
  slots["campaign"] = html_escape(result.campaign);
  slots["verdict"] = html_escape(calibrate_page::verdict(result));
  slots["origin"] = html_escape(calibrate_page::origin(result));
  slots["warnings"] = sections::warnings(result.warnings);
  slots["tiles"] = sections::tiles(result);
}

void add_levels(Slots& slots, const CalibrateResult& result) {
  constexpr std::string_view kNoLevel = "No specimen was loaded at one constant level.";
  const bool any = !result.levels.empty();
  slots["lives"] =
      sections::chart(calibrate_page::lives_chart(result), captions::lives(result), kNoLevel);
  slots["specimens_table"] = sections::table_or(any, tables::specimens(result), kNoLevel);
  slots["levels_table"] = sections::table_or(any, tables::levels(result), kNoLevel);
  slots["densities"] =
      sections::chart(calibrate_page::density_chart(result), captions::densities(), kNoFit);
  slots["goodness_table"] = sections::table_or(any, tables::goodness_of_fit(result), kNoLevel);
  slots["scale_by_tension"] = sections::chart(calibrate_page::scale_by_tension_chart(result),
                                              captions::scale_by_tension(), kNoFit);
  slots["scale_by_angle"] =
      sections::chart(calibrate_page::scale_by_angle_chart(result), captions::scale_by_angle(),
                      "No fitted level has a bend angle.");
  slots["probability"] = sections::probability_plots(result);
}

void add_shape(Slots& slots, const CalibrateResult& result) {
  std::vector<std::string> words = calibrate_page::shape_words(result);
  const std::vector<std::string> left_out = calibrate_page::left_out_words(result);
  words.insert(words.end(), left_out.begin(), left_out.end());
  slots["shape_words"] = sections::words(words);
  slots["common_shape_table"] = result.common_shape
                                    ? tables::common_shape(result) + tables::shape_tests(result)
                                    : std::string();
  slots["common_shape"] = sections::chart(calibrate_page::common_shape_chart(result),
                                          captions::common_shape(result), kNoFailure);
  slots["odd_levels_table"] =
      sections::table_or(result.common_shape && !result.common_shape->odd_levels.empty(),
                         tables::odd_levels(result), "No level was tested against others.");
}

void add_law(Slots& slots, const CalibrateResult& result) {
  constexpr std::string_view kNothing = "There is no specimen of constant load to draw.";
  slots["law_table"] = tables::law(result);
  slots["adequacy_words"] = sections::words(calibrate_page::adequacy_words(result));
  slots["stress_life"] =
      sections::chart(calibrate_page::stress_life_chart(result, StressLifeAxes::linear),
                      captions::stress_life(result), kNothing);
  slots["stress_life_log"] =
      sections::chart(calibrate_page::stress_life_chart(result, StressLifeAxes::logarithmic),
                      captions::stress_life_log(), kNothing);
  slots["law_lines_table"] = sections::table_or(result.stress_life.has_value(),
                                                tables::law_lines(result), "There is no law.");
}

void add_use(Slots& slots, const CalibrateResult& result) {
  constexpr std::string_view kNoUse =
      "There is no life law, or no use or validation level to draw it at.";
  slots["use_table"] =
      sections::table_or(!result.use_levels.empty(), tables::use_levels(result),
                         "No use level was asked for, or there is no law to predict its life.");
  slots["use"] = sections::chart(calibrate_page::use_chart(result, StressLifeAxes::linear),
                                 captions::use(), kNoUse);
  slots["use_log"] = sections::chart(calibrate_page::use_chart(result, StressLifeAxes::logarithmic),
                                     captions::use_log(), kNoUse);
  slots["validation_words"] = sections::words(calibrate_page::validation_words(result));
  slots["validation_table"] =
      sections::table_or(!result.validation.empty(), tables::validation(result),
                         "The campaign has no validation specimens that could be compared.");
  slots["mixes_table"] =
      sections::table_or(!result.mixes.empty(), tables::mixes(result), "No mix was asked for.");
}

nlohmann::json charts_json(const CalibrateResult& result) {
  nlohmann::json charts = nlohmann::json::object();
  for (const Chart& chart : calibrate_page::charts(result)) {
    charts[chart.id] = chart_json(chart);
  }
  return {{"charts", charts}};
}

}  // namespace

void write_calibrate_report(std::ostream& out, const CalibrateResult& result,
                            std::string_view program_version) {
  Slots slots;
  add_head(slots, result);
  add_levels(slots, result);
  add_shape(slots, result);
  add_law(slots, result);
  add_use(slots, result);
  std::ostringstream body;
  fill_template(body, calibrate_assets::body_html, slots);
  write_page(out, {"Tendon life: calibration of " + result.campaign, body.str(),
                   fmt::format("Made by host_sim {}.", program_version), charts_json(result),
                   calibrate_assets::draw_js});
}

}  // namespace host_sim
