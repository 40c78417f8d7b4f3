#include "tests/blind/scoring/judgement.hpp"

#include <algorithm>

namespace blind {
namespace {

using host_sim::diagnose::Candidate;
using host_sim::diagnose::FoundEffect;
using host_sim::diagnose::Verdict;

const Candidate* most_probable(const Record& record) {
  const auto& candidates = record.findings.candidates;
  const auto found = std::max_element(candidates.begin(), candidates.end(),
                                      [](const Candidate& one, const Candidate& other) {
                                        return one.probability < other.probability;
                                      });
  return found == candidates.end() ? nullptr : &*found;
}

bool holds(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

std::string Judgement::first() const {
  const Candidate* const candidate = most_probable(record_);
  return candidate == nullptr ? "" : candidate->id;
}

double Judgement::first_probability() const {
  const Candidate* const candidate = most_probable(record_);
  return candidate == nullptr ? 0 : candidate->probability;
}

bool Judgement::right_class() const {
  const auto& sets = record_.findings.equivalent_sets;
  const bool together = std::any_of(sets.begin(), sets.end(), [&](const auto& set) {
    return holds(set, answer_) && holds(set, first());
  });
  return right_first() || (record_.findings.verdict == Verdict::ambiguous && together);
}

bool Judgement::hides(const std::string& id) const {
  const auto& hidden = record_.truth.hidden;
  return std::any_of(hidden.begin(), hidden.end(), [&](const HiddenEffect& effect) {
    return !effect.outside && effect.id == id;
  });
}

bool Judgement::named() const {
  return record_.findings.verdict == Verdict::named;
}

bool Judgement::named_right() const {
  const auto& effects = record_.findings.effects;
  return !effects.empty() &&
         std::all_of(effects.begin(), effects.end(),
                     [&](const FoundEffect& effect) { return hides(effect.id); });
}

bool Judgement::named_all() const {
  return named() && named_right() && record_.findings.effects.size() == record_.truth.hidden.size();
}

bool Judgement::unknown() const {
  return record_.findings.verdict == Verdict::unknown;
}

bool Judgement::covered() const {
  return holds(record_.findings.credible_set, answer_);
}

bool Judgement::visible_at(double sigmas) const {
  const auto& z = record_.visibility;
  return !z.empty() && std::all_of(z.begin(), z.end(), [&](double one) { return one >= sigmas; });
}

}  // namespace blind
