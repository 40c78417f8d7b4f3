#include "tests/blind/making/make.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "hal/files/output_file.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace blind {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const HiddenEffect& effect) {
  return {{"id", effect.id},
          {"outside", effect.outside},
          {"numbers", effect.numbers},
          {"words", effect.texts}};
}

HiddenEffect effect_of(const Json& json) {
  HiddenEffect effect;
  effect.id = json.at("id").get<std::string>();
  effect.outside = json.at("outside").get<bool>();
  effect.numbers = json.at("numbers").get<std::map<std::string, std::vector<double>>>();
  effect.texts = json.at("words").get<std::map<std::string, std::string>>();
  return effect;
}

NominalFactors factors_of(const Json& json) {
  NominalFactors factors;
  factors.friction_coefficient = json.at("friction_coefficient").get<double>();
  factors.torque_constant = json.at("torque_constant").get<double>();
  factors.ipl_scale = json.at("ipl_scale").get<double>();
  factors.ipl_exponent = json.at("ipl_exponent").get<double>();
  factors.weibull_shape = json.at("weibull_shape").get<double>();
  return factors;
}

template <class Enum, std::size_t count>
Enum named(const Json& json, const std::array<Enum, count>& all) {
  const auto word = json.get<std::string>();
  for (const Enum one : all) {
    if (name_of(one) == word) {
      return one;
    }
  }
  throw std::runtime_error("a truth with the unknown word " + word);
}

using hal::files::OutputFile;
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

std::string truth_text(const Scenario& scenario, const std::string& made) {
  Json hidden = Json::array();
  for (const HiddenEffect& effect : scenario.hidden) {
    hidden.push_back(json_of(effect));
  }
  const NominalFactors& factors = scenario.nominal;
  Json json{{"seed", scenario.seed},
            {"data", name_of(scenario.data)},
            {"kind", name_of(scenario.kind)},
            {"design", name_of(scenario.design)},
            {"input", name_of(scenario.input)},
            {"temperatures", scenario.temperatures},
            {"specimens", scenario.specimens},
            {"hidden", std::move(hidden)},
            {"nominal_over_true",
             {{"friction_coefficient", factors.friction_coefficient},
              {"torque_constant", factors.torque_constant},
              {"ipl_scale", factors.ipl_scale},
              {"ipl_exponent", factors.ipl_exponent},
              {"weibull_shape", factors.weibull_shape}}},
            {"plan", scenario.plan}};
  if (!made.empty()) {
    json["simulation"] = Json::parse(made);
  }
  return json.dump(2) + "\n";
}

Scenario scenario_of(const std::string& truth) {
  const Json json = Json::parse(truth);
  Scenario scenario;
  scenario.seed = json.at("seed").get<std::uint64_t>();
  scenario.data = named(json.at("data"), std::array{Data::recordings, Data::lives});
  scenario.kind =
      named(json.at("kind"), std::array{CampaignKind::none, CampaignKind::one, CampaignKind::two,
                                        CampaignKind::three, CampaignKind::outside});
  scenario.design =
      named(json.at("design"), std::array{Design::crossed, Design::one_pose, Design::two_sided});
  scenario.input = named(json.at("input"), std::array{Input::load_cell, Input::motor_current});
  scenario.temperatures = json.at("temperatures").get<bool>();
  scenario.specimens = json.at("specimens").get<std::size_t>();
  scenario.nominal = factors_of(json.at("nominal_over_true"));
  for (const Json& effect : json.at("hidden")) {
    scenario.hidden.push_back(effect_of(effect));
  }
  return scenario;
}

SynthPlan nominal_plan(const Scenario& scenario) {
  SynthPlan plan = plan_of(scenario);
  const NominalFactors& factors = scenario.nominal;
  plan.model.sheath->friction_coefficient *= factors.friction_coefficient;
  if (plan.model.drive) {
    plan.model.drive->torque_constant_Nm_per_A *= factors.torque_constant;
  }
  if (plan.model.life) {
    plan.model.life->ipl_scale *= factors.ipl_scale;
    plan.model.life->ipl_exponent *= factors.ipl_exponent;
    plan.model.life->weibull_shape *= factors.weibull_shape;
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
