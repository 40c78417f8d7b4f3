#include "host_sim/report/diagnose/verdict.hpp"

#include <fmt/format.h>

#include "host_sim/diagnose/output/parts.hpp"
#include "host_sim/diagnose/output/words.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::Findings;
using diagnose::Part;
using diagnose::Verdict;

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& items, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) {
      text += i + 1 == items.size() ? fmt::format(" {} ", last) : ", ";
    }
    text += items[i];
  }
  return text;
}

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
    terms.push_back(diagnose::term_of(id));
  }
  const std::string causes = terms.empty() ? "" : ": " + listed(terms, "or");
  return "the model does not fit, and the data cannot tell which cause it is" + causes;
}

std::string unknown(const Findings& findings) {
  std::vector<std::string> terms;
  for (const diagnose::Step& step : findings.steps) {
    if (!step.effect.id.empty()) {
      terms.push_back(step.effect.term);
    }
  }
  return terms.empty() ? "the model does not fit, and nothing in the catalogue explains why"
                       : "the model does not fit, and the catalogue explains it in part, by " +
                             listed(terms, "and");
}

std::string sentence_of(const Findings& findings) {
  switch (findings.verdict) {
    case Verdict::none:
      return "nothing is wrong with the model that this campaign could show";
    case Verdict::named:
      return named(findings);
    case Verdict::ambiguous:
      return ambiguous(findings);
    case Verdict::unknown:
      return unknown(findings);
  }
  return {};
}

}  // namespace

std::string verdict(const diagnose::Diagnosis& diagnosis) {
  std::string text;
  for (const Part& part : diagnose::parts_of(diagnosis)) {
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
                      : "Found in " + listed(from, "and") +
                            ". Probabilities are calibrated on simulated campaigns; "
                            "intervals are of 95\u00a0%.";
}

}  // namespace host_sim::diagnose_page
