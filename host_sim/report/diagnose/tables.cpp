#include "host_sim/report/diagnose/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/output/prose.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::diagnose_page::tables {
namespace {

using diagnose::Estimate;
using diagnose::Findings;

constexpr int kGainDigits = 4;  // before and after are often near to each other

std::string unit_text(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

std::string interval_text(const Estimate& estimate) {
  if (estimate.low == estimate.high) {
    return "none";
  }
  const auto end = [](double value) {
    return std::isinf(value) ? std::string("no limit") : number_text(value);
  };
  return fmt::format("{} to {}", end(estimate.low), end(estimate.high));
}

std::vector<std::string> cells_of(const Estimate& estimate) {
  return {quantity_text(estimate.value, unit_text(estimate.unit)), interval_text(estimate)};
}

/// The change from before to after in percent of before, signed.
std::string change_text(const diagnose::Metric& metric) {
  constexpr double kPercent = 100;
  const double change = metric.after - metric.before;
  const auto description = diagnose::description_of(metric.name);
  const std::string sign = change > 0 ? "+" : "";
  if (description.good == diagnose::MetricDescription::Good::low && metric.before > 0) {
    return sign + quantity_text(kPercent * change / metric.before, "%");
  }
  return sign + quantity_text(change, description.unit);
}

std::string goal_text(const diagnose::MetricDescription& description) {
  switch (description.good) {
    case diagnose::MetricDescription::Good::low:
      return "low";
    case diagnose::MetricDescription::Good::high:
      return "high";
    case diagnose::MetricDescription::Good::goal:
      return number_text(description.goal);
  }
  return {};
}

std::string joined(const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) {
    text += (text.empty() ? "" : ", ") + id;
  }
  return text;
}

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

std::string effects(const Findings& findings) {
  Table table("Effects",
              {"Effect", "What it is", "Probability", "In the model", "What it does to life"},
              Table::Cells::texts);
  for (const diagnose::FoundEffect& effect : findings.effects) {
    table.row(effect.id, {effect.term, percent_text(effect.probability), effect.equation,
                          effect.life_consequence});
  }
  return table.html();
}

std::string parameters(const Findings& findings) {
  Table table("Parameters of the effects", {"Effect and parameter", "Value", "95\u00a0%"});
  for (const diagnose::FoundEffect& effect : findings.effects) {
    for (const Estimate& estimate : effect.parameters) {
      table.row(effect.id + ", " + estimate.name, cells_of(estimate));
    }
  }
  return table.html();
}

std::string refitted(const Findings& findings) {
  Table table("Refitted parameters", {"Parameter", "Value", "95\u00a0%"});
  for (const Estimate& estimate : findings.refitted) {
    table.row(estimate.name, cells_of(estimate));
  }
  return table.html();
}

std::string equivalents(const Findings& findings) {
  Table table("Effects that cannot be distinguished here",
              {"Not distinguishable in this campaign", "What they are",
               "Experiment that distinguishes them"},
              Table::Cells::texts);
  for (const auto& set : findings.equivalent_sets) {
    std::vector<std::string> terms;
    terms.reserve(set.size());
    for (const std::string& id : set) {
      terms.push_back(diagnose::term_of(id, findings));
    }
    table.row(joined(set), {joined(terms), diagnose::experiments_for(set)});
  }
  return table.html();
}

std::string invisible(const Findings& findings) {
  Table table("Effects that this campaign cannot show",
              {"Effect", "What it is", "Why, and what would show it"}, Table::Cells::texts);
  for (const diagnose::Invisible& one : findings.invisible) {
    table.row(one.id, {diagnose::term_of(one.id), one.why});
  }
  return table.html();
}

std::string gain(const diagnose::HeldOutGain& gain) {
  Table table("Gain", {"Measure", "Good is", "Nominal", "Extended", "Change", "Better"});
  for (const diagnose::Metric& metric : gain.metrics) {
    const auto description = diagnose::description_of(metric.name);
    table.row(description.name,
              {goal_text(description), quantity_text(metric.before, description.unit, kGainDigits),
               quantity_text(metric.after, description.unit, kGainDigits), change_text(metric),
               diagnose::improved(metric) ? "yes" : "no"});
  }
  return table.html();
}

std::string steps(const std::vector<diagnose::Step>& steps) {
  Table table("Steps", {"Model", "Probability", "RMSE of output", "RMSE of input",
                        "Log predictive density", "Sessions better"});
  for (const diagnose::Step& step : steps) {
    const bool nominal = step.effect.id.empty();
    table.row(nominal ? "Capstan alone" : "+ " + step.effect.id,
              {nominal ? "" : percent_text(step.effect.probability),
               quantity_text(step.output_rmse_N, "N"), quantity_text(step.input_rmse_N, "N"),
               number_text(step.log_predictive_density),
               nominal ? "" : fmt::format("{} of {}", step.sessions_better, step.sessions)});
  }
  return table.html();
}

std::string discrepancies(const Findings& findings) {
  const bool extended = !findings.extensions.empty();
  Table table("Discrepancies", {"Covariate", "Statistic", "p, nominal model", "p, extended model"});
  for (const diagnose::Discrepancy& one : findings.discrepancies) {
    table.row(one.covariate, {number_text(one.statistic), p_text(one.p),
                              extended ? p_text(one.p_after) : "nothing extended"});
  }
  return table.html();
}

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
    html += row(diagnose::candidate_prose(candidate.id), diagnose::term_of(candidate.id, findings),
                candidate.probability, strong);
  }
  if (left_out > 0) {
    html += row(counted_text(left_out, "other candidate"),
                left_out > 1 ? "together" : "hardly possible", rest, false);
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

}  // namespace host_sim::diagnose_page::tables
