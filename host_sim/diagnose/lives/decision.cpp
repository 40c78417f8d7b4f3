#include "host_sim/diagnose/lives/decision.hpp"

#include <algorithm>
#include <map>

namespace host_sim::diagnose::lives {
namespace {

constexpr double kSurelyNone = 0.8;
constexpr double kAgrees_p = 0.05;
/// Nothing is named where residuals are as large by chance more often than this.
constexpr double kNameable_p = 0.1;

/// Probability that an effect takes part.
std::map<std::string, double> shares_of(const std::vector<Hypothesis>& hypotheses) {
  std::map<std::string, double> shares;
  for (const Hypothesis& hypothesis : hypotheses) {
    if (!hypothesis.outside) {
      for (const std::string& effect : hypothesis.effects) {
        shares[effect] += hypothesis.probability;
      }
    }
  }
  return shares;
}

const Hypothesis* with_effects(const std::vector<Hypothesis>& hypotheses,
                               const std::vector<std::string>& effects) {
  for (const Hypothesis& hypothesis : hypotheses) {
    if (!hypothesis.outside && hypothesis.effects == effects) {
      return &hypothesis;
    }
  }
  return nullptr;
}

}  // namespace

std::vector<Candidate> candidates_of(const std::vector<Hypothesis>& hypotheses) {
  std::map<std::string, double> sums;
  for (const Hypothesis& hypothesis : hypotheses) {
    sums[hypothesis.id()] += hypothesis.probability;
  }
  sums.try_emplace("unknown", 0.0);
  std::vector<Candidate> candidates;
  candidates.reserve(sums.size());
  for (const auto& [id, probability] : sums) {
    candidates.push_back({id, probability});
  }
  std::ranges::stable_sort(candidates, [](const Candidate& one, const Candidate& other) {
    return one.probability > other.probability;
  });
  return candidates;
}

Decision decide(const std::vector<Hypothesis>& hypotheses, double p) {
  Decision decision;
  decision.candidates = candidates_of(hypotheses);
  decision.credible_set = credible_set_of(decision.candidates);
  const std::map<std::string, double> shares = shares_of(hypotheses);
  for (const auto& [effect, share] : shares) {
    if (share >= kNamed) {
      decision.effects.push_back(effect);
    }
  }
  decision.best = with_effects(hypotheses, decision.effects);
  if (decision.best != nullptr && !decision.effects.empty() && p <= kNameable_p) {
    decision.verdict = Verdict::named;
  } else if (decision.candidates.front().id == "none" &&
             (decision.candidates.front().probability >= kSurelyNone || p > kAgrees_p)) {
    decision.verdict = Verdict::none;
  } else if (decision.candidates.front().id == "unknown") {
    decision.verdict = Verdict::unknown;
  } else {
    decision.verdict = Verdict::ambiguous;
    decision.effects.clear();
    const auto first = std::ranges::find_if(hypotheses, [](const Hypothesis& hypothesis) {
      return !hypothesis.outside && !hypothesis.effects.empty();
    });
    if (first != hypotheses.end()) {
      decision.best = &*first;
      decision.effects = first->effects;
    }
  }
  for (const std::string& effect : decision.effects) {
    decision.probabilities.push_back(shares.at(effect));
  }
  return decision;
}

}  // namespace host_sim::diagnose::lives
