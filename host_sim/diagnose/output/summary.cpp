#include "host_sim/diagnose/output/summary.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>
#include <string>

#include "hal/files/text.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/output/prose.hpp"

namespace host_sim::diagnose {

using hal::files::printable;

namespace {

/// Below it a candidate is not reported.
constexpr double kLeastReported = 0.005;

std::string figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit == "1" ? text : text + " " + unit;
}

/// Without an interval where it has none.
void write_estimate(std::ostream& out, const Estimate& estimate, std::string_view indent) {
  fmt::print(out, "{}{:<25} {}", indent, printable(estimate.name),
             printable(with_unit(figure(estimate.value), estimate.unit)));
  if (estimate.low != estimate.high) {
    fmt::print(out, "  (95 %: {} .. {})", figure(estimate.low), figure(estimate.high));
  }
  out << '\n';
}

void write_effects(std::ostream& out, const Findings& findings) {
  for (const FoundEffect& effect : findings.effects) {
    fmt::print(out, "  {:<22}probability {:.3f}  {}\n", printable(effect.id), effect.probability,
               printable(effect.term));
    for (const Estimate& estimate : effect.parameters) {
      write_estimate(out, estimate, "    ");
    }
  }
}

/// "no effect", "compliance and slack".
std::string candidate_label(const std::string& id) {
  return id == "none" || id == "unknown" ? term_of(id) : candidate_prose(id);
}

/// What it may be, where it is not one thing alone.
void write_candidates(std::ostream& out, const Findings& findings) {
  if (findings.verdict != Verdict::ambiguous && findings.verdict != Verdict::unknown) {
    return;
  }
  for (const Candidate& candidate : findings.candidates) {
    if (candidate.probability >= kLeastReported) {
      fmt::print(out, "  {}: probability {:.3f}\n", printable(candidate_label(candidate.id)),
                 candidate.probability);
    }
  }
}

void write_gain(std::ostream& out, const HeldOutGain& gain) {
  if (gain.metrics.empty()) {
    return;
  }
  fmt::print(out, "  improvement on data that the fit did not use{}\n",
             gain.held_out_by.empty() ? "" : ", held out by " + printable(gain.held_out_by));
  for (const Metric& metric : gain.metrics) {
    const MetricDescription description = description_of(metric.name);
    fmt::print(out, "    {:<36}{} -> {}{}\n", printable(description.name), figure(metric.before),
               with_unit(figure(metric.after), description.unit),
               improved(metric) ? "" : "  (not better)");
  }
}

void write_steps(std::ostream& out, const std::vector<Step>& steps) {
  if (!steps.empty()) {
    out << "  best models of the catalogue, error on sessions that the fit did not use\n";
  }
  for (const Step& step : steps) {
    fmt::print(
        out, "    {:<36}output {} N, input {} N\n",
        step.effect.id.empty() ? "nominal model (Capstan alone)" : "+ " + printable(step.effect.id),
        figure(step.output_rmse_N), figure(step.input_rmse_N));
  }
}

void write_remainder(std::ostream& out, const Findings& findings) {
  if (findings.remainder) {
    fmt::print(out, "  remains: {}\n", printable(remainder_prose(*findings.remainder)));
  }
}

void write_correction(std::ostream& out, const Findings& findings) {
  if (findings.correction) {
    fmt::print(out, "  correction: {}\n", printable(correction_summary(*findings.correction)));
  }
}

void write_invisible(std::ostream& out, const Findings& findings) {
  for (const Invisible& one : findings.invisible) {
    fmt::print(out, "  not detectable here: {}: {}\n", printable(one.id), printable(one.why));
  }
}

void write_same(std::ostream& out, const Findings& findings) {
  for (const auto& set : findings.equivalent_sets) {
    std::string ids;
    for (const std::string& id : set) {
      ids += (ids.empty() ? "" : ", ") + printable(id);
    }
    const std::string experiments = experiments_for(set);
    fmt::print(out, "  not distinguishable here: {}{}{}\n", ids,
               experiments.empty() ? "" : "; to distinguish them: ", experiments);
  }
}

void write_part(std::ostream& out, const DataFindings& part, const std::string& cost) {
  const Findings& findings = *part.findings;
  fmt::print(out, "{}: {}\n", part.name, name_of(findings.verdict));
  if (!findings.prose.empty()) {
    fmt::print(out, "  {}\n", printable(findings.prose));
  }
  for (const Doubt& doubt : findings.doubts) {
    fmt::print(out, "  doubt: {}\n", printable(doubt_prose(doubt)));
  }
  write_effects(out, findings);
  write_candidates(out, findings);
  for (const Estimate& estimate : findings.refitted) {
    write_estimate(out, estimate, "  refitted ");
  }
  write_gain(out, findings.gain);
  write_steps(out, findings.steps);
  write_remainder(out, findings);
  write_correction(out, findings);
  fmt::print(out, "  cost in life: {}\n", cost);
  write_same(out, findings);
  write_invisible(out, findings);
  if (!findings.next_experiment.empty()) {
    fmt::print(out, "  next experiment: {}\n", printable(findings.next_experiment));
  }
}

}  // namespace

void write_summary(std::ostream& out, std::string_view campaign, const Diagnosis& diagnosis) {
  fmt::print(out, "{}: {}\n", printable(campaign), name_of(diagnosis.verdict()));
  for (const DataFindings& part : findings_by_data(diagnosis)) {
    write_part(
        out, part,
        part.name == "lives" ? cost_prose(*diagnosis.lives) : cost_prose(*diagnosis.tension));
  }
  for (const std::string& warning : diagnosis.warnings) {
    fmt::print(out, "warning: {}\n", printable(warning));
  }
}

}  // namespace host_sim::diagnose
