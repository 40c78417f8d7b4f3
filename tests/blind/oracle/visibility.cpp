#include "tests/blind/oracle/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "host_sim/synth/campaign/sessions.hpp"
#include "host_sim/synth/plan/plan.hpp"
#include "tests/blind/oracle/life_visibility.hpp"
#include "tests/blind/oracle/session_information.hpp"
#include "tests/blind/oracle/traces.hpp"

namespace blind {
namespace {

using host_sim::synth::Channels;
using host_sim::synth::Setting;
using host_sim::synth::SynthPlan;

SynthPlan silent(const Scenario& scenario) {
  SynthPlan plan = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  plan.noise = {};
  plan.scatter = {};
  return plan;
}

SynthPlan without(SynthPlan plan, const std::string& id) {
  std::erase_if(plan.hidden, [&](const auto& hidden) { return hidden.id == id; });
  return plan;
}

std::vector<double> difference(std::vector<double> one, const std::vector<double>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    one[i] -= other[i];
  }
  return one;
}

double visibility(const Scenario& scenario, const std::string& id) {
  const SynthPlan noisy = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  const SynthPlan all = silent(scenario);
  const SynthPlan fewer = without(all, id);
  const Disturbance disturbance{std::numbers::sqrt2 * noisy.noise.log_tension_sd, noisy.noise.ar1,
                                noisy.scatter.log_gain_sd, noisy.scatter.friction_sd};
  Information information = Information::Zero();
  for (const Setting& setting : host_sim::synth::settings_of(*all.recordings, scenario.seed)) {
    const Channels with = session_channels(all, setting, {}, scenario.seed);
    const Channels base = session_channels(fewer, setting, {}, scenario.seed);
    information += session_information(
        difference(log_ratio(with, scenario.input), log_ratio(base, scenario.input)),
        signed_bend_rad(base), disturbance);
  }
  return sigmas_of(information);
}

}  // namespace

std::vector<double> visibility_of(const Scenario& scenario) {
  std::vector<double> result;
  for (const HiddenEffect& effect : scenario.hidden) {
    result.push_back(scenario.data == Data::lives ? life_visibility(scenario, effect.id)
                                                  : visibility(scenario, effect.id));
  }
  return result;
}

}  // namespace blind
