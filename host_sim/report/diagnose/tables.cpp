#include "host_sim/report/diagnose/tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/diagnose/output/words.hpp"
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
  const auto words = diagnose::words_of(metric.name);
  const std::string sign = change > 0 ? "+" : "";
  if (words.good == diagnose::MetricWords::Good::low && metric.before > 0) {
    return sign + quantity_text(kPercent * change / metric.before, "%");
  }
  return sign + quantity_text(change, words.unit);
}

std::string goal_text(const diagnose::MetricWords& words) {
  switch (words.good) {
    case diagnose::MetricWords::Good::low:
      return "low";
    case diagnose::MetricWords::Good::high:
      return "high";
    case diagnose::MetricWords::Good::goal:
      return number_text(words.goal);
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
  Table table("Effects that look the same here",
              {"Look the same in this campaign", "What they are", "What tells them apart"},
              Table::Cells::texts);
  for (const auto& set : findings.equivalent_sets) {
    std::vector<std::string> terms;
    terms.reserve(set.size());
    for (const std::string& id : set) {
      terms.push_back(diagnose::term_of(id));
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

std::string gain(const diagnose::Gain& gain) {
  Table table("Gain", {"Measure", "Good is", "Nominal", "Extended", "Change", "Better"});
  for (const diagnose::Metric& metric : gain.metrics) {
    const auto words = diagnose::words_of(metric.name);
    table.row(words.name, {goal_text(words), quantity_text(metric.before, words.unit, kGainDigits),
                           quantity_text(metric.after, words.unit, kGainDigits),
                           change_text(metric), diagnose::improved(metric) ? "yes" : "no"});
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

}  // namespace host_sim::diagnose_page::tables
