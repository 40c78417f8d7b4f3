#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/blind/records/record.hpp"

namespace blind::test {

using host_sim::diagnose::Candidate;
using host_sim::diagnose::Verdict;

/// A truth that hides some effects of the catalogue.
inline Scenario hiding(const std::vector<std::string>& ids) {
  Scenario truth;
  truth.kind = ids.empty() ? Kind::none : ids.size() == 1 ? Kind::one : Kind::two;
  for (const std::string& id : ids) {
    truth.hidden.push_back({id, false, {}, {}});
  }
  return truth;
}

inline Scenario hiding_outside(const std::string& id) {
  Scenario truth;
  truth.kind = Kind::outside;
  truth.hidden.push_back({id, true, {}, {}});
  return truth;
}

/// A record of an answer.
inline Record answered(Scenario truth, Verdict verdict, std::vector<Candidate> candidates,
                       std::vector<std::string> named = {}) {
  Record record;
  record.truth = std::move(truth);
  record.findings.verdict = verdict;
  record.findings.candidates = std::move(candidates);
  for (std::string& id : named) {
    host_sim::diagnose::FoundEffect effect;
    effect.id = std::move(id);
    effect.probability = 0.97;
    record.findings.effects.push_back(std::move(effect));
  }
  return record;
}

}  // namespace blind::test
