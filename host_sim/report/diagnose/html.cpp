#include "host_sim/report/diagnose/html.hpp"

#include <fmt/format.h>

#include <sstream>

#include "host_sim/diagnose/output/parts.hpp"
#include "host_sim/diagnose/output/words.hpp"
#include "host_sim/report/diagnose/assets.hpp"
#include "host_sim/report/diagnose/captions.hpp"
#include "host_sim/report/diagnose/charts.hpp"
#include "host_sim/report/diagnose/pictures.hpp"
#include "host_sim/report/diagnose/ranking.hpp"
#include "host_sim/report/diagnose/tables.hpp"
#include "host_sim/report/diagnose/tiles.hpp"
#include "host_sim/report/diagnose/verdict.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"

namespace host_sim {
namespace {

using diagnose::Diagnosis;
using diagnose::Findings;
using elements::table_or;
namespace captions = diagnose_page::captions;
namespace tables = diagnose_page::tables;

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
  slots["words"] = paragraph("lead", findings.words);
  slots["effects"] =
      table_or(!findings.effects.empty(), tables::effects(findings), "No effect was named.");
  slots["parameters"] = has_parameters(findings) ? tables::parameters(findings) : std::string();
  slots["refitted"] = table_or(!findings.refitted.empty(), tables::refitted(findings),
                               "No parameter was refitted.");
}

void add_causes(Slots& slots, const Findings& findings) {
  slots["causes"] =
      findings.candidates.empty()
          ? elements::empty("No candidate was tried.")
          : paragraph("caption", captions::ranking(findings)) + diagnose_page::ranking(findings);
  slots["next"] =
      findings.next_experiment.empty()
          ? std::string()
          : fmt::format("<p class=\"next\"><strong>Experiment to make next.</strong> {}</p>\n",
                        html_escape(findings.next_experiment));
  slots["equivalents"] =
      findings.equivalent_sets.empty()
          ? paragraph("caption", "Each effect that is visible here can be told from the others.")
          : tables::equivalents(findings);
}

std::string gain(const Findings& findings) {
  if (!findings.steps.empty()) {
    return paragraph("caption", captions::steps()) + tables::steps(findings.steps);
  }
  return findings.gain.metrics.empty()
             ? elements::empty("Nothing was extended, so that there is no gain to measure.")
             : paragraph("caption", captions::gain(findings.gain)) + tables::gain(findings.gain);
}

void add_evidence(Slots& slots, const Findings& findings) {
  slots["gain"] = gain(findings);
  slots["discrepancies"] =
      findings.discrepancies.empty()
          ? elements::empty("No covariate was tested.")
          : paragraph("caption", captions::discrepancies()) + tables::discrepancies(findings);
  slots["invisible"] = table_or(!findings.invisible.empty(), tables::invisible(findings),
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

std::string body(std::string_view campaign, const Diagnosis& diagnosis) {
  Slots slots;
  slots["campaign"] = html_escape(campaign);
  slots["verdict"] = html_escape(diagnose_page::verdict(diagnosis));
  slots["origin"] = html_escape(diagnose_page::origin(diagnosis));
  slots["warnings"] = elements::warnings(diagnosis.warnings);
  slots["tiles"] = diagnose_page::tiles(diagnosis);
  const auto& tension = diagnosis.tension;
  slots["recordings"] =
      tension ? part("recordings", "Recordings", tension->findings,
                     diagnose_page::pictures(*tension), diagnose::cost_words(*tension))
              : std::string();
  const auto& lives = diagnosis.lives;
  slots["lives"] = lives ? part("lives", "Lives", lives->findings, diagnose_page::pictures(*lives),
                                diagnose::cost_words(*lives))
                         : std::string();
  std::ostringstream out;
  fill_template(out, diagnose_assets::body_html, slots);
  return out.str();
}

nlohmann::json charts_json(const Diagnosis& diagnosis) {
  nlohmann::json charts = nlohmann::json::object();
  for (const Chart& chart : diagnose_page::charts(diagnosis)) {
    charts[chart.id] = chart_json(chart);
  }
  return {{"charts", charts}};
}

}  // namespace

void write_diagnose_report(std::ostream& out, std::string_view campaign, const Diagnosis& diagnosis,
                           std::string_view program_version) {
  write_page(out, {"Tendon life: diagnosis of " + std::string(campaign), body(campaign, diagnosis),
                   fmt::format("Made by host_sim {}.", program_version), charts_json(diagnosis),
                   diagnose_assets::draw_js});
}

}  // namespace host_sim
