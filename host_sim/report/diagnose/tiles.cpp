#include "host_sim/report/diagnose/tiles.hpp"

#include <fmt/format.h>

#include "host_sim/diagnose/output/parts.hpp"
#include "host_sim/diagnose/output/words.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::diagnose_page {
namespace {

using diagnose::Part;
using elements::tile;

constexpr int kGainDigits = 4;  // before and after are often near to each other

std::string capital(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string effects(const Part& part) {
  std::string html;
  for (const diagnose::FoundEffect& effect : part.findings->effects) {
    html += tile(capital(effect.term.empty() ? effect.id : effect.term),
                 percent_text(effect.probability), fmt::format("probability of {}", effect.id));
  }
  return html;
}

/// @param both whether the other part has gains too, so that each says whose they are
std::string gains(const Part& part, bool both) {
  std::string html;
  for (const diagnose::Metric& metric : part.findings->gain.metrics) {
    const diagnose::MetricWords words = diagnose::words_of(metric.name);
    html +=
        tile(capital(words.name), quantity_text(metric.after, words.unit, kGainDigits),
             fmt::format("{}{} with the nominal model", both ? std::string(part.name) + ": " : "",
                         quantity_text(metric.before, words.unit, kGainDigits)));
  }
  return html;
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

std::string tiles(const diagnose::Diagnosis& diagnosis) {
  std::string html = tile("Verdict", std::string(word_of(diagnosis.verdict())),
                          "none, named, ambiguous or unknown");
  const std::vector<Part> parts = diagnose::parts_of(diagnosis);
  for (const Part& part : parts) {
    html += effects(part) + gains(part, parts.size() > 1);
  }
  return html + life(diagnosis);
}

}  // namespace host_sim::diagnose_page
