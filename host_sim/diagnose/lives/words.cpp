#include "host_sim/diagnose/lives/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host_sim/diagnose/lives/term.hpp"

namespace host_sim::diagnose::lives {
namespace {

bool is_effect(const std::string& id) {
  return std::ranges::any_of(effects::life_effects(),
                             [&](const auto& effect) { return effect->id() == id; });
}

/// Effects that take part in any candidate of a set, in order of their ids.
std::set<std::string> effects_of(const std::vector<std::string>& set) {
  std::set<std::string> ids;
  for (const std::string& candidate : set) {
    std::size_t begin = 0;
    while (begin <= candidate.size()) {
      const std::size_t end = std::min(candidate.find('+', begin), candidate.size());
      const std::string id = candidate.substr(begin, end - begin);
      if (is_effect(id)) {
        ids.insert(id);
      }
      begin = end + 1;
    }
  }
  return ids;
}

std::string least_look(const Omnibus& omnibus) {
  const auto least = std::ranges::min_element(
      omnibus.looks, [](const Look& one, const Look& other) { return one.p < other.p; });
  return least == omnibus.looks.end() ? "" : least->covariate;
}

std::string named_words(const Findings& findings) {
  std::string words;
  for (const FoundEffect& effect : findings.effects) {
    words += fmt::format("{}{} ({}, probability {:.3f})", words.empty() ? "" : " and ", effect.id,
                         effect.term, effect.probability);
  }
  return words;
}

}  // namespace

std::string experiment_for(const std::vector<std::string>& credible_set) {
  const std::set<std::string> ids = effects_of(credible_set);
  std::set<std::string> experiments;
  for (const std::string& id : ids) {
    for (const effects::Separation& separation : life_effect(id).separations()) {
      if (ids.size() == 1 || ids.contains(std::string(separation.other))) {
        experiments.insert(std::string(separation.experiment));
      }
    }
  }
  if (experiments.empty() && !ids.empty()) {
    experiments.insert(
        "cross levels of T_eff with mean tension, bend ratio, lots and storage, and "
        "test more specimens at each");
  }
  return fmt::format("{}", fmt::join(experiments, "; "));
}

std::string verdict_words(const Findings& findings, const Omnibus& before, const Omnibus& after) {
  switch (findings.verdict) {
    case Verdict::none:
      return fmt::format(
          "Nothing that this campaign could show is wrong with the nominal law (p = {:.2g} for the "
          "largest residual).",
          before.p);
    case Verdict::named:
      return fmt::format(
          "The nominal law is wrong (p = {:.2g}); {} explains it, and nothing is left (p = "
          "{:.2g}).",
          before.p, named_words(findings), after.p);
    case Verdict::ambiguous:
      return fmt::format(
          "Something may be wrong with the nominal law (p = {:.2g}, most against {}), and these "
          "lives do not say what: {} hold 95 % together.",
          before.p, least_look(before), fmt::join(findings.credible_set, ", "));
    case Verdict::unknown:
      break;
  }
  if (!after.looks.empty()) {
    return fmt::format(
        "The nominal law is wrong (p = {:.2g}), and with the best of the catalogue structure is "
        "left against {} (p = {:.2g}).",
        before.p, least_look(after), after.p);
  }
  return fmt::format(
      "The nominal law is wrong (p = {:.2g}, most against {}) in a way that no effect of the "
      "catalogue explains.",
      before.p, least_look(before));
}

}  // namespace host_sim::diagnose::lives
