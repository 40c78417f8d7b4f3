#include "host_sim/report/diagnose/head.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/output/prose.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::DataFindings;
using diagnose::Findings;
using diagnose::listed;
using diagnose::Verdict;

std::string named(const Findings& findings) {
  std::vector<std::string> terms;
  for (const diagnose::FoundEffect& effect : findings.effects) {
    terms.push_back(fmt::format("{} ({})", effect.term.empty() ? effect.id : effect.term,
                                percent_text(effect.probability)));
  }
  return "the model leaves out " + (terms.empty() ? "an effect" : listed(terms, "and"));
}

std::string ambiguous(const Findings& findings) {
  std::vector<std::string> terms;
  for (const std::string& id : findings.credible_set) {
    terms.push_back(diagnose::term_of(id, findings));
  }
  const std::string causes = terms.empty() ? "" : ": " + listed(terms, "or");
  return "the model does not fit, and the data do not determine the cause" + causes;
}

std::string unknown(const Findings& findings) {
  std::vector<std::string> terms;
  for (const diagnose::Step& step : findings.steps) {
    if (!step.effect.id.empty()) {
      terms.push_back(step.effect.term.empty() ? step.effect.id : step.effect.term);
    }
  }
  return terms.empty() ? "the model does not fit, and nothing in the catalogue explains why"
                       : "the model does not fit, and the catalogue explains it in part, by " +
                             listed(terms, "and");
}

std::string sentence_of(const Findings& findings) {
  switch (findings.verdict) {
    case Verdict::none:
      return "the campaign shows no discrepancy from the model";
    case Verdict::named:
      return named(findings);
    case Verdict::ambiguous:
      return ambiguous(findings);
    case Verdict::unknown:
      return unknown(findings);
  }
  return {};
}

using elements::tile;

constexpr int kGainDigits = 4;  // before and after are often near to each other

std::string capital(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string effects(const DataFindings& part) {
  std::string html;
  for (const diagnose::FoundEffect& effect : part.findings->effects) {
    html += tile(capital(effect.term.empty() ? effect.id : effect.term),
                 percent_text(effect.probability), fmt::format("probability of {}", effect.id));
  }
  return html;
}

/// @param both whether the other part has gains too, so that each says whose they are
std::string gains(const DataFindings& part, bool both) {
  std::string html;
  for (const diagnose::Metric& metric : part.findings->gain.metrics) {
    const diagnose::MetricDescription description = diagnose::description_of(metric.name);
    html +=
        tile(capital(description.name), quantity_text(metric.after, description.unit, kGainDigits),
             fmt::format("{}{} with the nominal model", both ? std::string(part.name) + ": " : "",
                         quantity_text(metric.before, description.unit, kGainDigits)));
  }
  return html;
}

std::string remainder(const diagnose::Diagnosis& diagnosis) {
  if (!diagnosis.tension || !diagnosis.tension->findings.remainder) {
    return {};
  }
  const diagnose::Remainder& left = *diagnosis.tension->findings.remainder;
  std::string note = "of the squared error of the nominal model";
  for (const auto& [name, rmse_N] :
       {std::pair("input", left.input_rmse_N), std::pair("output", left.output_rmse_N)}) {
    if (std::isfinite(rmse_N)) {
      note += fmt::format(", {} of {} tension", quantity_text(rmse_N, "N", 2), name);
    }
  }
  if (!left.covariate.empty()) {
    note += fmt::format(", most against {} (p {})", diagnose::covariate_prose(left.covariate),
                        p_text(left.p));
  }
  return tile("What remains", percent_text(left.share), note);
}

std::string correction(const diagnose::Diagnosis& diagnosis) {
  if (!diagnosis.tension || !diagnosis.tension->findings.correction) {
    return {};
  }
  const diagnose::Correction& added = *diagnosis.tension->findings.correction;
  return tile("Correction", quantity_text(added.after_N, "N", 2),
              fmt::format("input tension, {} before it: a table over {}, which is no cause",
                          quantity_text(added.before_N, "N", 2),
                          diagnose::covariate_prose(added.covariate)));
}

std::string life(const diagnose::Diagnosis& diagnosis) {
  std::string html;
  if (diagnosis.tension && !diagnosis.tension->findings.extensions.empty()) {
    html +=
        tile("Life promised over life", number_text(1 / diagnosis.tension->damage_ratio) + " times",
             "nominal over extended model, for the damage of these recordings");
  }
  if (diagnosis.lives && !diagnosis.lives->findings.extensions.empty()) {
    html += tile("B10 promised over B10", number_text(diagnosis.lives->b10_ratio) + " times",
                 "nominal over extended model, at the lowest level");
  }
  return html;
}

}  // namespace

std::string verdict(const diagnose::Diagnosis& diagnosis) {
  std::string text;
  for (const DataFindings& part : diagnose::findings_by_data(diagnosis)) {
    text += fmt::format("{}{}: {}.", text.empty() ? "" : " ",
                        part.name == "lives" ? "Lives" : "Recordings", sentence_of(*part.findings));
  }
  return text.empty() ? "There was nothing to diagnose." : text;
}

std::string origin(const diagnose::Diagnosis& diagnosis) {
  std::vector<std::string> from;
  if (diagnosis.tension) {
    from.emplace_back("recordings of tension");
  }
  if (diagnosis.lives) {
    const auto& points = diagnosis.lives->picture.points;
    from.push_back(points.empty() ? "lives of specimens"
                                  : "the lives of " + counted_text(points.size(), "specimen"));
  }
  return from.empty() ? "The campaign holds neither recordings nor lives."
                      : "Found in " + listed(from, "and") + ". Probabilities are " +
                            (diagnosis.tension ? "those of gains on sessions held out"
                                               : "scored on simulated campaigns") +
                            "; intervals are of 95\u00a0%.";
}

std::string tiles(const diagnose::Diagnosis& diagnosis) {
  std::string html = tile("Verdict", std::string(name_of(diagnosis.verdict())),
                          "none, named, ambiguous or unknown") +
                     remainder(diagnosis) + correction(diagnosis);
  const std::vector<DataFindings> parts = diagnose::findings_by_data(diagnosis);
  for (const DataFindings& part : parts) {
    html += effects(part) + gains(part, parts.size() > 1);
  }
  return html + life(diagnosis);
}

}  // namespace host_sim::diagnose_page
