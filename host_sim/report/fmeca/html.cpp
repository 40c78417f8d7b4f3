#include "host_sim/report/fmeca/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"

/// Files of the page of failure modes, embedded when the program is built.
namespace host_sim::fmeca_page_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::fmeca_page_assets

namespace host_sim {
namespace {

using fmeca::Assessed;
using fmeca::Assessment;
using fmeca::FailureMode;
using fmeca::RiskTable;

/// The shade of a level, from 0 to 3.
std::size_t shade_of(const RiskTable& table, std::size_t level) {
  constexpr std::size_t kDarkest = 3;
  return table.levels.size() < 2 ? 0 : level * kDarkest / (table.levels.size() - 1);
}

std::string name_of(const FailureMode& mode) {
  return fmt::format("{}: {}", mode.component, mode.mode);
}

std::string tiles(const Assessment& assessment) {
  std::string html;
  const RiskTable& table = *assessment.table;
  for (std::size_t level = table.levels.size(); level-- > 0;) {
    const auto count = std::ranges::count(assessment.modes, level, &Assessed::level);
    html += elements::tile(table.levels[level].name, count_text(static_cast<std::uint64_t>(count)),
                           fmt::format("risk from {:g}", table.levels[level].from));
  }
  return html;
}

std::size_t level_at(const RiskTable& table, int risk) {
  const auto above = std::ranges::find_if(
      table.levels, [risk](const fmeca::RiskLevel& level) { return level.from > risk; });
  return static_cast<std::size_t>(above - table.levels.begin()) - 1;
}

std::string matrix_cell(const Assessment& assessment, int severity, int occurrence) {
  std::string places;
  for (std::size_t i = 0; i < assessment.modes.size(); ++i) {
    const Assessed& one = assessment.modes[i];
    if (one.mode->severity == severity && one.occurrence == occurrence) {
      places += fmt::format("{}<a href=\"#mode-{}\" title=\"{}\">{}</a>", places.empty() ? "" : " ",
                            i + 1, html_escape(name_of(*one.mode)), i + 1);
    }
  }
  const int risk = severity * occurrence;
  return fmt::format("<td class=\"shade-{}\"><small>{}</small><br>{}</td>",
                     shade_of(*assessment.table, level_at(*assessment.table, risk)), risk, places);
}

std::string matrix(const Assessment& assessment) {
  const fmeca::Ratings& largest = assessment.table->largest;
  std::string html =
      "<div class=\"table matrix\" tabindex=\"0\" role=\"region\" aria-label=\"Criticality "
      "matrix\">\n<table>\n<thead><tr><th scope=\"col\">Severity</th>";
  for (int occurrence = 1; occurrence <= largest.occurrence; ++occurrence) {
    html += fmt::format("<th scope=\"col\">{}</th>", occurrence);
  }
  html += "</tr></thead>\n<tbody>\n";
  for (int severity = largest.severity; severity >= 1; --severity) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", severity);
    for (int occurrence = 1; occurrence <= largest.occurrence; ++occurrence) {
      html += matrix_cell(assessment, severity, occurrence);
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n<tfoot><tr><th></th><td colspan=\"" +
         std::to_string(largest.occurrence) + "\">Occurrence</td></tr></tfoot>\n</table>\n</div>\n";
}

std::string ranking(const Assessment& assessment) {
  const bool has_rpn = assessment.has_rpn();
  std::string html = fmt::format(
      "<div class=\"table numbered\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Ranking\">\n<table>\n"
      "<thead><tr><th scope=\"col\">No.</th><th scope=\"col\">Failure mode</th><th "
      "scope=\"col\">Cause, mechanism</th><th scope=\"col\" class=\"number\">Rank</th>{}<th "
      "scope=\"col\" class=\"number\">Risk</th><th scope=\"col\">Level</th><th scope=\"col\" "
      "class=\"number\">Severity</th><th scope=\"col\" class=\"number\">Occurrence</th>{}"
      "</tr></thead>\n<tbody>\n",
      has_rpn ? "<th scope=\"col\" class=\"number\">RPN</th>" : "",
      has_rpn ? "<th scope=\"col\" class=\"number\">Detection</th>" : "");
  for (std::size_t i = 0; i < assessment.modes.size(); ++i) {
    const Assessed& one = assessment.modes[i];
    const FailureMode& mode = *one.mode;
    const auto number = [](int value) {
      return fmt::format("<td class=\"number\">{}</td>", value);
    };
    html += fmt::format(
        "<tr id=\"mode-{0}\"><th scope=\"row\">{0}</th><td>{1}</td><td>{2}</td><td "
        "class=\"number\">{3}</td>{4}{5}<td><span class=\"level shade-{6}\">{7}</span></td>{8}<td "
        "class=\"number\">{9}{10}</td>{11}</tr>\n",
        i + 1, html_escape(name_of(mode)),
        html_escape(mode.mechanism.empty() ? mode.cause : mode.cause + ": " + mode.mechanism),
        one.rank, has_rpn ? number(*one.rpn) : "", number(one.risk),
        shade_of(*assessment.table, one.level),
        html_escape(assessment.table->levels[one.level].name), number(mode.severity),
        one.occurrence, one.field ? "*" : "", has_rpn ? number(*mode.detection) : "");
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string watch_list(const std::vector<std::string>& names) {
  if (names.empty()) {
    return "nothing";
  }
  std::string html;
  for (const std::string& name : names) {
    html += fmt::format("{}<code>{}</code><br><small>{}</small>", html.empty() ? "" : "<br>",
                        html_escape(name), html_escape(fmeca::what_is(name).words));
  }
  return html;
}

std::string watches(const Assessment& assessment) {
  std::string html =
      "<div class=\"table numbered watches\" tabindex=\"0\" role=\"region\" aria-label=\"What "
      "watches "
      "each\">\n<table>\n<thead><tr><th scope=\"col\">No.</th><th scope=\"col\">Failure mode</th>"
      "<th scope=\"col\">Warned by</th><th scope=\"col\">Seen by</th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < assessment.modes.size(); ++i) {
    const FailureMode& mode = *assessment.modes[i].mode;
    html += fmt::format(
        "<tr><th "
        "scope=\"row\">{}</th><td>{}<br><small>{}</small></td><td>{}</td><td>{}</td></tr>\n",
        i + 1, html_escape(name_of(mode)), html_escape(mode.cause), watch_list(mode.warned_by),
        watch_list(mode.seen_by));
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string blind(const Assessment& assessment) {
  std::vector<std::string> nothing;
  std::vector<std::string> too_late;
  for (const Assessed& one : assessment.modes) {
    const FailureMode& mode = *one.mode;
    const std::string words = fmt::format("{} ({}), risk {}", name_of(mode), mode.cause, one.risk);
    if (mode.warned_by.empty()) {
      (mode.seen_by.empty() ? nothing : too_late).push_back(words);
    }
  }
  std::string html = nothing.empty() ? "<p class=\"clear\">Each failure mode is watched.</p>\n"
                                     : elements::words(nothing);
  if (!too_late.empty()) {
    html += "<h3>Seen only when it has failed</h3>\n" + elements::words(too_late);
  }
  return html;
}

std::string field(const Assessment& assessment) {
  Table table("Field records", {"Failure mode", "Events", "Operating hours", "Events per hour",
                                "60 % upper limit", "Occurrence in the table", "from the field"});
  bool any = false;
  for (const Assessed& one : assessment.modes) {
    if (one.field) {
      any = true;
      table.row(fmt::format("{} ({})", name_of(*one.mode), one.mode->cause),
                {count_text(one.field->events), number_text(one.field->operating_h),
                 number_text(static_cast<double>(one.field->events) / one.field->operating_h),
                 number_text(one.field->limit_per_h()), std::to_string(one.mode->occurrence),
                 std::to_string(one.occurrence)});
    }
  }
  return any ? "<section aria-labelledby=\"field-heading\">\n<h2 id=\"field-heading\">* From the "
               "field</h2>\n<p class=\"caption\">The rating is that of the rate below which the "
               "true one lies with 60\u00a0% confidence: few hours without an event prove "
               "little.</p>\n" +
                   table.html() + "</section>\n"
             : "";
}

}  // namespace

void write_fmeca_report(std::ostream& out, const Assessment& assessment,
                        std::string_view program_version) {
  Slots slots;
  slots["name"] = html_escape(assessment.table->name);
  slots["verdict"] = html_escape(fmeca::sentence_of(assessment));
  slots["tiles"] = tiles(assessment);
  slots["matrix"] = matrix(assessment);
  slots["ranking"] = ranking(assessment);
  slots["watches"] = watches(assessment);
  slots["blind"] = blind(assessment);
  slots["field"] = field(assessment);
  std::ostringstream body;
  fill_template(body, fmeca_page_assets::body_html, slots);
  write_page(out, {"Tendon life: failure modes",
                   body.str(),
                   fmt::format("Made by host_sim {}.", program_version),
                   {{"charts", nlohmann::json::object()}},
                   fmeca_page_assets::draw_js});
}

}  // namespace host_sim
