#include "host_sim/diagnose/tension/prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host_sim/diagnose/audit.hpp"
#include "host_sim/diagnose/force/prose.hpp"

namespace host_sim::diagnose {
namespace {

const effects::TensionEffect* effect_of(const Audit& audit, std::string_view id) {
  for (const EffectAudit& entry : audit.effects) {
    if (entry.effect->id() == id) {
      return entry.effect;
    }
  }
  return nullptr;
}

std::set<std::string> effects_in(const std::string& id) {
  const std::size_t plus = id.find('+');
  if (plus == std::string::npos) {
    return {id};
  }
  return {id.substr(0, plus), id.substr(plus + 1)};
}

/// The first effect of one candidate that the other does not hold; null where there is none.
const effects::TensionEffect* other_than(const Audit& audit, const std::string& one,
                                         const std::string& other) {
  const std::set<std::string> known = effects_in(other);
  for (const std::string& id : effects_in(one)) {
    if (!known.contains(id)) {
      return effect_of(audit, id);
    }
  }
  return nullptr;
}

}  // namespace

std::string verdict_prose(const Findings& findings, std::size_t sessions) {
  switch (findings.verdict) {
    case Verdict::none:
      return fmt::format(
          "Nothing in {} recordings disagrees with the model beyond noise and the scatter of "
          "sessions.",
          sessions);
    case Verdict::named:
      return "The recordings disagree with the model, and the cause is " +
             listed(findings.effects) + ".";
    case Verdict::ambiguous: {
      std::string prose =
          "The recordings disagree with the model, and more than one cause explains it:";
      for (const std::string& id : findings.credible_set) {
        prose += ' ' + id + ',';
      }
      prose.back() = '.';
      return prose;
    }
    case Verdict::unknown: {
      std::string prose =
          "The recordings contain structure that no effect or pair of effects of the catalogue "
          "explains.";
      const auto strongest =
          std::ranges::max_element(findings.discrepancies, {}, &Discrepancy::statistic);
      if (strongest != findings.discrepancies.end()) {
        prose += fmt::format(" It is strongest against {}.", strongest->covariate);
      }
      return prose;
    }
  }
  return "";
}

std::string next_experiment(const Findings& findings, const Audit& audit) {
  if (findings.verdict == Verdict::unknown) {
    const auto strongest =
        std::ranges::max_element(findings.discrepancies, {}, &Discrepancy::statistic);
    return strongest == findings.discrepancies.end()
               ? ""
               : fmt::format("repeat a few sessions with nothing changed but the {}",
                             strongest->covariate);
  }
  if (findings.verdict != Verdict::ambiguous || findings.credible_set.size() < 2) {
    return "";
  }
  const std::string& first = findings.credible_set[0];
  const std::string& second = findings.credible_set[1];
  const effects::TensionEffect* one = other_than(audit, first, second);
  const effects::TensionEffect* other = other_than(audit, second, first);
  if (one != nullptr && other != nullptr) {
    return experiment_for(*one, *other);
  }
  const effects::TensionEffect* doubtful = one != nullptr ? one : other;
  return doubtful == nullptr
             ? ""
             : fmt::format(
                   "record more sessions in which {} would show: a wider range of what it "
                   "depends on, at the same poses and loads",
                   doubtful->term());
}

}  // namespace host_sim::diagnose
