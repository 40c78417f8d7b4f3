#include "tests/blind/making/make.hpp"

#include "host_sim/io/output_file.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace blind {
namespace {

using host_sim::OutputFile;
using host_sim::synth::SynthPlan;

SynthPlan plan_of(const Scenario& scenario) {
  return host_sim::synth::parse_synth_plan(scenario.plan,
                                           "blind plan " + std::to_string(scenario.seed));
}

void write(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

SynthPlan nominal_plan(const Scenario& scenario) {
  SynthPlan plan = plan_of(scenario);
  const NominalFactors& factors = scenario.nominal;
  plan.sheath->friction_coefficient *= factors.friction_coefficient;
  if (plan.drive) {
    plan.drive->torque_constant_Nm_per_A *= factors.torque_constant;
  }
  if (plan.life) {
    plan.life->ipl_scale *= factors.ipl_scale;
    plan.life->ipl_exponent *= factors.ipl_exponent;
    plan.life->weibull_shape *= factors.weibull_shape;
  }
  return plan;
}

Sealed make_blind_campaign(const Scenario& scenario, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const SynthPlan plan = plan_of(scenario);
  host_sim::synth::MakeOptions options;
  options.seed = scenario.seed;
  options.threads = 1;
  const auto made = host_sim::synth::make_campaign(plan, options, folder);
  write(folder / "campaign.toml", host_sim::synth::campaign_text(nominal_plan(scenario)));
  Sealed sealed;
  sealed.text = truth_text(scenario, host_sim::synth::truth_json(plan, options.seed, made));
  sealed.sha256 = host_sim::synth::sha256(sealed.text);
  return sealed;
}

}  // namespace blind
