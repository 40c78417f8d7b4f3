#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {

/// What cannot be told apart is said once, with each effect once.
inline void expect_sets(std::vector<std::vector<std::string>> sets) {
  for (std::vector<std::string>& set : sets) {
    std::ranges::sort(set);
    EXPECT_EQ(std::ranges::adjacent_find(set), set.end()) << testing::PrintToString(set);
  }
  std::ranges::sort(sets);
  EXPECT_EQ(std::ranges::adjacent_find(sets), sets.end()) << testing::PrintToString(sets);
}

inline Findings findings_of(const std::vector<effects::ForceRecord>& records) {
  Findings findings = diagnose_forces(records, nominal(), kWire, {}).findings;
  expect_sets(findings.equivalent_sets);
  for (const FoundEffect& effect : findings.effects) {
    EXPECT_EQ(std::ranges::find(findings.invisible, effect.id, &Invisible::id),
              findings.invisible.end())
        << effect.id << " was found";
  }
  return findings;
}

inline std::vector<std::string> ids_of(const Findings& findings) {
  std::vector<std::string> ids;
  for (const FoundEffect& effect : findings.effects) {
    ids.push_back(effect.id);
  }
  return ids;
}

inline const Estimate& estimate(const Findings& findings, const std::string& name) {
  for (const FoundEffect& effect : findings.effects) {
    for (const Estimate& parameter : effect.parameters) {
      if (parameter.name == name) {
        return parameter;
      }
    }
  }
  throw std::out_of_range(name);
}

inline double metric(const Findings& findings, const std::string& name, bool after) {
  const auto metric = std::ranges::find(findings.gain.metrics, name, &Metric::name);
  if (metric == findings.gain.metrics.end()) {
    throw std::out_of_range(name);
  }
  return after ? metric->after : metric->before;
}

}  // namespace host_sim::diagnose
