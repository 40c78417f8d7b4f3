#include "host_sim/diagnose/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace host_sim::diagnose {
namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void append(std::string& all, const std::string& more, std::string_view between) {
  if (!all.empty() && !more.empty()) {
    all += between;
  }
  all += more;
}

void append(HeldOutGain& all, const HeldOutGain& more, std::string_view part) {
  append(all.held_out_by, more.held_out_by, ", ");
  for (Metric metric : more.metrics) {
    const bool taken = std::any_of(all.metrics.begin(), all.metrics.end(),
                                   [&](const Metric& other) { return other.name == metric.name; });
    if (taken) {
      metric.name = std::string(part) + "_" + metric.name;
    }
    all.metrics.push_back(metric);
  }
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::named:
      return "named";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unknown:
      return "unknown";
  }
  return "";
}

std::vector<std::string> credible_set_of(const std::vector<Candidate>& candidates, double share) {
  std::vector<std::string> ids;
  double sum = 0;
  for (const Candidate& candidate : candidates) {
    if (sum >= share) {
      break;
    }
    ids.push_back(candidate.id);
    sum += candidate.probability;
  }
  return ids;
}

bool improves(const HeldOutGain& gain) {
  constexpr double kNotWorse = 1.02;
  constexpr double kWithinScatter = 1.1;
  // Damage is about the sixth power of a force: 10 % of it are 1.7 % of that.
  constexpr double kDamageNotWorse = 1.5;
  constexpr double kSmallDamage_percent = 10;
  const auto metric = [&](std::string_view name) -> const Metric* {
    const auto found = std::ranges::find(gain.metrics, name, &Metric::name);
    return found == gain.metrics.end() ? nullptr : &*found;
  };
  const Metric* const density = metric("log_predictive_density");
  const bool denser = density != nullptr && density->after > density->before;
  if (const Metric* const input = metric("input_rmse_N")) {
    const Metric* const damage = metric("damage_error_percent");
    if (damage != nullptr &&
        damage->after > std::max(kDamageNotWorse * damage->before, kSmallDamage_percent)) {
      return false;
    }
    const bool not_worse =
        input->after <= (gain.within_scatter ? kWithinScatter : kNotWorse) * input->before;
    return input->after < input->before || (denser && not_worse);
  }
  const Metric* const output = metric("rmse_N");
  return output != nullptr ? output->after < output->before : denser;
}

bool withdraw_unless_improved(Findings& findings) {
  const bool withdrawn = findings.verdict == Verdict::named && !improves(findings.gain);
  if (withdrawn) {
    findings.verdict = Verdict::ambiguous;
    findings.extensions.clear();
  }
  return withdrawn;
}

std::vector<std::string_view> effects_in(std::string_view candidate) {
  std::vector<std::string_view> effects;
  for (std::size_t first = 0; first <= candidate.size();) {
    const std::size_t end = std::min(candidate.find('+', first), candidate.size());
    effects.push_back(candidate.substr(first, end - first));
    first = end + 1;
  }
  return effects;
}

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

bool spoil_all(const std::vector<Doubt>& doubts) {
  return std::ranges::any_of(
      doubts, [](const Doubt& doubt) { return doubt.spoils && doubt.sessions.empty(); });
}

std::string doubt_prose(const Doubt& doubt) {
  constexpr std::size_t kMost = 5;
  std::string where;
  if (!doubt.sessions.empty()) {
    std::vector<std::string> sessions(doubt.sessions.begin(),
                                      doubt.sessions.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                   kMost, doubt.sessions.size())));
    if (doubt.sessions.size() > kMost) {
      sessions.push_back(fmt::format("{} more", doubt.sessions.size() - kMost));
    }
    where = fmt::format("{} {}", doubt.sessions.size() > 1 ? "sessions" : "session",
                        listed(sessions, "and"));
  }
  where += !where.empty() && !doubt.column.empty() ? ", " : "";
  where += doubt.column;
  const std::string_view done = !doubt.spoils ? ""
                                : doubt.sessions.empty()
                                    ? " (nothing is named before that is settled)"
                                : doubt.sessions.size() > 1 ? " (they are left out)"
                                                            : " (it is left out)";
  return fmt::format("{}{}{}{}", where, where.empty() ? "" : ": ", doubt.words, done);
}

std::string no_gain_prose(const Findings& findings) {
  return findings.gain.metrics.empty() || improves(findings.gain)
             ? ""
             : " In the model it would not improve predictions of data that the fit did not use: "
               "nothing "
               "was extended.";
}

Verdict Diagnosis::verdict() const {
  Verdict verdict = Verdict::none;
  if (tension) {
    verdict = tension->findings.verdict;
  }
  if (lives) {
    verdict = std::max(verdict, lives->findings.verdict);
  }
  return verdict;
}

std::vector<DataFindings> findings_by_data(const Diagnosis& diagnosis) {
  std::vector<DataFindings> parts;
  if (diagnosis.tension) {
    parts.push_back({"recordings", &diagnosis.tension->findings});
  }
  if (diagnosis.lives) {
    parts.push_back({"lives", &diagnosis.lives->findings});
  }
  return parts;
}

Findings merged(const Diagnosis& diagnosis) {
  Findings all;
  all.verdict = diagnosis.verdict();
  if (diagnosis.tension) {
    all.remainder = diagnosis.tension->findings.remainder;
    all.correction = diagnosis.tension->findings.correction;
  }
  for (const DataFindings& part : findings_by_data(diagnosis)) {
    const Findings& one = *part.findings;
    append(all.effects, one.effects);
    append(all.candidates, one.candidates);
    append(all.credible_set, one.credible_set);
    append(all.equivalent_sets, one.equivalent_sets);
    append(all.invisible, one.invisible);
    append(all.next_experiment, one.next_experiment, "; ");
    append(all.gain, one.gain, part.name);
    append(all.steps, one.steps);
    append(all.discrepancies, one.discrepancies);
    append(all.refitted, one.refitted);
    append(all.extensions, one.extensions);
    append(all.prose, one.prose, " ");
    append(all.doubts, one.doubts);
  }
  return all;
}

}  // namespace host_sim::diagnose
