#include "host_sim/report/diagnose/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/output/words.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::Candidate;
using diagnose::Findings;

constexpr double kLeastShown = 0.002;
constexpr std::size_t kMostShown = 12;

std::vector<Candidate> most_probable_first(std::vector<Candidate> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& one, const Candidate& other) {
                     return one.probability > other.probability;
                   });
  return candidates;
}

bool credible(const Findings& findings, const std::string& id) {
  return std::find(findings.credible_set.begin(), findings.credible_set.end(), id) !=
         findings.credible_set.end();
}

std::string bar(double probability, bool strong) {
  constexpr double kLength = 100;
  const double length =
      std::isfinite(probability) ? kLength * std::clamp(probability, 0.0, 1.0) : 0;
  return fmt::format(
      "<svg class=\"bar\" viewBox=\"0 0 100 10\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\"><rect class=\"track\" width=\"100\" height=\"10\"/><rect "
      "class=\"{}\" width=\"{:.2f}\" height=\"10\"/></svg>",
      strong ? "strong" : "weak", length);
}

std::string probability_text(double probability) {
  constexpr double kLeastTold = 0.001;
  return probability < kLeastTold ? "below 0.1\u00a0%" : percent_text(probability);
}

std::string row(const std::string& name, const std::string& note, double probability, bool strong) {
  return fmt::format(
      "<tr><th scope=\"row\">{}<br><small>{}</small></th><td class=\"track\">{}</td>"
      "<td class=\"number\">{}</td></tr>\n",
      html_escape(name), html_escape(note), bar(probability, strong),
      html_escape(probability_text(probability)));
}

}  // namespace

std::string ranking(const Findings& findings) {
  if (findings.candidates.empty()) {
    return {};
  }
  std::string html =
      "<div class=\"table ranking\" tabindex=\"0\" role=\"region\" aria-label=\"Candidates by "
      "probability\">\n<table>\n<thead><tr><th scope=\"col\">Candidate</th><th scope=\"col\" "
      "class=\"track\"><span class=\"quiet\">as a bar</span></th><th scope=\"col\" "
      "class=\"number\">Probability</th></tr></thead>\n<tbody>\n";
  double rest = 0;
  std::size_t shown = 0, left_out = 0;
  for (const Candidate& candidate : most_probable_first(findings.candidates)) {
    const bool strong = credible(findings, candidate.id);
    if (shown == kMostShown || (candidate.probability < kLeastShown && !strong)) {
      rest += candidate.probability;
      ++left_out;
      continue;
    }
    ++shown;
    html += row(diagnose::candidate_words(candidate.id), diagnose::term_of(candidate.id),
                candidate.probability, strong);
  }
  if (left_out > 0) {
    html += row(counted_text(left_out, "other candidate"),
                left_out > 1 ? "together" : "hardly possible", rest, false);
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

}  // namespace host_sim::diagnose_page
