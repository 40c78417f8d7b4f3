#include "host_sim/report/calibrate/sections.hpp"

#include <fmt/format.h>

#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/level_look.hpp"
#include "host_sim/report/calibrate/level_tables.hpp"
#include "host_sim/report/calibrate/texts.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/escape.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page::sections {
namespace {

using elements::tile;

std::string probability_caption(const calibrate::LevelResult& level) {
  if (!has_fit(level)) {
    return fmt::format("No Weibull line: {}.", problem_text(level.weibull().problem));
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

}  // namespace

std::string tiles(const calibrate::CalibrateResult& result) {
  std::string html = result.stress_life
                         ? law_tiles(*result.stress_life)
                         : tile("Life law", "none", "it could not be fitted: see the warnings");
  if (result.common_shape) {
    html += tile("p of one shape", p_text(p_of(result.common_shape->homogeneity)),
                 rejects(result.common_shape->homogeneity) ? "rejected at 5\u00a0%"
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

}  // namespace host_sim::calibrate_page::sections
