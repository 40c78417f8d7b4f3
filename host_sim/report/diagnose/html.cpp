#include "host_sim/report/diagnose/html.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string_view>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/output/prose.hpp"
#include "host_sim/report/diagnose/captions.hpp"
#include "host_sim/report/diagnose/charts.hpp"
#include "host_sim/report/diagnose/head.hpp"
#include "host_sim/report/diagnose/tables.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"

/// Files of the page of a diagnosis, embedded when the program is built.
namespace host_sim::diagnose_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view part_html;
extern const std::string_view recordings_html;
extern const std::string_view lives_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::diagnose_assets

namespace host_sim::diagnose_page {
namespace {

using diagnose::Diagnosis;
using diagnose::Findings;

std::string caption(const std::string& text) {
  return fmt::format("<p class=\"caption\">{}</p>\n", html_escape(text));
}

std::string in_pair(const std::string& html) {
  return fmt::format("<div>\n{}</div>\n", html);
}

std::string traces(const diagnose::TensionDiagnosis& tension) {
  constexpr std::string_view kNothing = "There is no recording of this session to draw.";
  if (tension.traces.empty()) {
    return elements::empty("There is no recording to draw.");
  }
  std::string html = caption(captions::traces(tension)) + "<div class=\"pair\">\n";
  for (const std::size_t trace : worst_traces(tension, kMostTraces)) {
    html += in_pair(
        elements::chart(trace_chart(tension, trace), captions::trace(tension, trace), kNothing));
    html += in_pair(
        elements::chart(loop_chart(tension, trace), captions::loop(tension, trace), kNothing));
  }
  return html + "</div>\n";
}

std::string causes(const diagnose::TensionDiagnosis& tension) {
  if (tension.causes.empty()) {
    return {};
  }
  std::string html = caption(captions::causes()) + "<div class=\"pair\">\n";
  for (std::size_t i = 0; i < tension.causes.size(); ++i) {
    html += in_pair(elements::chart(cause_chart(tension, i), captions::cause(tension, i), ""));
  }
  return html + "</div>\n";
}

std::string sessions(const diagnose::TensionDiagnosis& tension) {
  if (tension.session_refits.empty()) {
    return {};
  }
  std::string html = caption(captions::sessions()) + "<div class=\"pair\">\n";
  for (const SessionParameter parameter : {SessionParameter::friction, SessionParameter::gain}) {
    html += in_pair(elements::chart(session_chart(tension, parameter), "", ""));
  }
  return html + "</div>\n";
}

std::string remainders(const diagnose::TensionDiagnosis& tension) {
  if (tension.remainders.empty()) {
    return elements::empty("There is no residual to draw.");
  }
  std::string html = caption(captions::remainders()) + "<div class=\"pair\">\n";
  for (std::size_t i = 0; i < tension.remainders.size(); ++i) {
    html += in_pair(elements::chart(remainder_chart(tension, i), captions::remainder(tension, i),
                                    "There is nothing to draw in this direction."));
  }
  return html + "</div>\n";
}

std::string filled(std::string_view page, const Slots& slots) {
  std::ostringstream out;
  fill_template(out, page, slots);
  return out.str();
}

std::string pictures(const diagnose::TensionDiagnosis& tension) {
  return filled(diagnose_assets::recordings_html, {{"traces", traces(tension)},
                                                   {"causes", causes(tension)},
                                                   {"sessions", sessions(tension)},
                                                   {"remainders", remainders(tension)}});
}

std::string pictures(const diagnose::LifeDiagnosis& lives) {
  constexpr std::string_view kNothing = "There is no life to draw.";
  const Chart after = ratio_chart(lives, Model::extended);
  return filled(
      diagnose_assets::lives_html,
      {{"weibull", elements::chart(weibull_chart(lives), captions::weibull(lives), kNothing)},
       {"ratio_before",
        elements::chart(ratio_chart(lives, Model::nominal), captions::ratio_before(), kNothing)},
       {"ratio_after", after.layers.empty()
                           ? std::string()
                           : in_pair(elements::chart(after, captions::ratio_after(), kNothing))}});
}

std::string paragraph(std::string_view kind, const std::string& text) {
  return text.empty() ? std::string()
                      : fmt::format("<p class=\"{}\">{}</p>\n", kind, html_escape(text));
}

bool has_parameters(const Findings& findings) {
  for (const diagnose::FoundEffect& effect : findings.effects) {
    if (!effect.parameters.empty()) {
      return true;
    }
  }
  return false;
}

void add_found(Slots& slots, const Findings& findings) {
  slots["prose"] = paragraph("lead", findings.prose);
  slots["effects"] = elements::table_or(!findings.effects.empty(), tables::effects(findings),
                                        "No effect was named.");
  slots["parameters"] = has_parameters(findings) ? tables::parameters(findings) : std::string();
  slots["refitted"] = elements::table_or(!findings.refitted.empty(), tables::refitted(findings),
                                         "No parameter was refitted.");
}

void add_causes(Slots& slots, const Findings& findings) {
  slots["causes"] =
      findings.candidates.empty()
          ? elements::empty("No candidate was tried.")
          : paragraph("caption", captions::ranking(findings)) + tables::ranking(findings);
  slots["next"] =
      findings.next_experiment.empty()
          ? std::string()
          : fmt::format("<p class=\"next\"><strong>Experiment to make next.</strong> {}</p>\n",
                        html_escape(findings.next_experiment));
  slots["equivalents"] =
      findings.equivalent_sets.empty()
          ? paragraph("caption", "All detectable effects can be distinguished from each other.")
          : tables::equivalents(findings);
}

std::string drawn(const Chart& chart, const std::string& text) {
  return chart.layers.empty() ? std::string() : elements::chart(chart, text, "");
}

std::string gain(const Findings& findings) {
  std::string html;
  if (!findings.gain.metrics.empty()) {
    html += paragraph("caption", captions::gain(findings.gain)) + tables::gain(findings.gain) +
            drawn(gain_chart(findings.gain), captions::gain_chart());
  }
  if (!findings.steps.empty()) {
    html += paragraph("caption", captions::steps(findings)) + tables::steps(findings.steps) +
            drawn(steps_chart(findings), captions::steps_chart());
  }
  return html.empty()
             ? elements::empty("Nothing was extended, so that there is no gain to measure.")
             : html;
}

void add_evidence(Slots& slots, const Findings& findings) {
  slots["gain"] = gain(findings);
  slots["discrepancies"] =
      findings.discrepancies.empty()
          ? elements::empty("No covariate was tested.")
          : paragraph("caption", captions::discrepancies()) + tables::discrepancies(findings);
  slots["invisible"] = elements::table_or(!findings.invisible.empty(), tables::invisible(findings),
                                          "Each effect of the catalogue would show here.");
}

std::string part(std::string_view id, std::string_view title, const Findings& findings,
                 const std::string& pictures, const std::string& cost) {
  Slots slots;
  slots["part"] = id;
  slots["title"] = title;
  slots["pictures"] = pictures;
  slots["cost"] = html_escape(cost);
  add_found(slots, findings);
  add_causes(slots, findings);
  add_evidence(slots, findings);
  std::ostringstream out;
  fill_template(out, diagnose_assets::part_html, slots);
  return out.str();
}

/// Doubts first.
std::vector<std::string> warnings_of(const Diagnosis& diagnosis) {
  std::vector<std::string> warnings;
  for (const diagnose::DataFindings& of_data : diagnose::findings_by_data(diagnosis)) {
    for (const diagnose::Doubt& doubt : of_data.findings->doubts) {
      warnings.push_back("In doubt: " + diagnose::doubt_prose(doubt));
    }
  }
  warnings.insert(warnings.end(), diagnosis.warnings.begin(), diagnosis.warnings.end());
  return warnings;
}

std::string body(std::string_view campaign, const Diagnosis& diagnosis) {
  Slots slots;
  slots["campaign"] = html_escape(campaign);
  slots["verdict"] = html_escape(verdict(diagnosis));
  slots["origin"] = html_escape(origin(diagnosis));
  slots["warnings"] = elements::warnings(warnings_of(diagnosis));
  slots["tiles"] = tiles(diagnosis);
  const auto& tension = diagnosis.tension;
  slots["recordings"] = tension ? part("recordings", "Recordings", tension->findings,
                                       pictures(*tension), diagnose::cost_prose(*tension))
                                : std::string();
  const auto& lives = diagnosis.lives;
  slots["lives"] = lives ? part("lives", "Lives", lives->findings, pictures(*lives),
                                diagnose::cost_prose(*lives))
                         : std::string();
  std::ostringstream out;
  fill_template(out, diagnose_assets::body_html, slots);
  return out.str();
}

nlohmann::json charts_json(const Diagnosis& diagnosis) {
  nlohmann::json drawn = nlohmann::json::object();
  for (const Chart& chart : charts(diagnosis)) {
    drawn[chart.id] = chart_json(chart);
  }
  return {{"charts", drawn}};
}

}  // namespace
}  // namespace host_sim::diagnose_page

namespace host_sim {

void write_diagnose_report(std::ostream& out, std::string_view campaign,
                           const diagnose::Diagnosis& diagnosis, std::string_view program_version) {
  write_page(out, {"Tendon life: diagnosis of " + std::string(campaign),
                   diagnose_page::body(campaign, diagnosis),
                   fmt::format("Made by host_sim {}.", program_version),
                   diagnose_page::charts_json(diagnosis), diagnose_assets::draw_js});
}

}  // namespace host_sim
