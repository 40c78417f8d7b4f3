#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/scoring/record.hpp"

namespace blind::test {

using host_sim::diagnose::Candidate;
using host_sim::diagnose::Verdict;

/// A truth that hides some effects of the catalogue.
inline Scenario hiding(const std::vector<std::string>& ids) {
  Scenario truth;
  truth.kind = ids.empty()       ? CampaignKind::none
               : ids.size() == 1 ? CampaignKind::one
               : ids.size() == 2 ? CampaignKind::two
                                 : CampaignKind::three;
  for (const std::string& id : ids) {
    truth.hidden.push_back({id, false, {}, {}});
  }
  return truth;
}

inline Scenario hiding_outside(const std::string& id) {
  Scenario truth;
  truth.kind = CampaignKind::outside;
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

/// Three short sessions with a sheath that wears.
inline Scenario small_scenario() {
  Scenario scenario;
  scenario.seed = 7;
  scenario.kind = CampaignKind::one;
  scenario.hidden.push_back({"friction_wear",
                             false,
                             {{"change", {0.3}}, {"reference_cycles", {1000}}, {"exponent", {1}}},
                             {{"law", "wear"}}});
  scenario.nominal.friction_coefficient = 1.25;
  scenario.plan = R"(
[campaign]
name = "small"
[model.sheath]
friction_coefficient = 0.1
bend_angle_deg = 270.0
[recordings]
bend_angles_deg = 180.0
output_means_N = 30.0
output_amplitudes_N = 10.0
frequencies_Hz = 1.0
travels_mm = 40.0
start_cycles = [0.0, 500.0, 1000.0]
sample_rate_Hz = 50.0
duration_s = 2.0
channels = ["input_tension_N", "output_tension_N", "tendon_velocity_m_s", "bend_angle_deg"]
[noise]
log_tension_sd = 0.01
[effects.friction_wear]
change = 0.3
reference_cycles = 1000.0
exponent = 1.0
)";
  return scenario;
}

}  // namespace blind::test
