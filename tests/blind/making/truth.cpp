#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/blind/making/make.hpp"

namespace blind {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const HiddenEffect& effect) {
  return {{"id", effect.id},
          {"outside", effect.outside},
          {"numbers", effect.numbers},
          {"words", effect.words}};
}

HiddenEffect effect_of(const Json& json) {
  HiddenEffect effect;
  effect.id = json.at("id").get<std::string>();
  effect.outside = json.at("outside").get<bool>();
  effect.numbers = json.at("numbers").get<std::map<std::string, std::vector<double>>>();
  effect.words = json.at("words").get<std::map<std::string, std::string>>();
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
    if (word_of(one) == word) {
      return one;
    }
  }
  throw std::runtime_error("a truth with the unknown word " + word);
}

}  // namespace

std::string truth_text(const Scenario& scenario, const std::string& made) {
  Json hidden = Json::array();
  for (const HiddenEffect& effect : scenario.hidden) {
    hidden.push_back(json_of(effect));
  }
  const NominalFactors& factors = scenario.nominal;
  Json json{{"seed", scenario.seed},
            {"data", word_of(scenario.data)},
            {"kind", word_of(scenario.kind)},
            {"design", word_of(scenario.design)},
            {"input", word_of(scenario.input)},
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
      named(json.at("kind"), std::array{Kind::none, Kind::one, Kind::two, Kind::outside});
  scenario.design = named(json.at("design"), std::array{Design::crossed, Design::one_pose});
  scenario.input = named(json.at("input"), std::array{Input::load_cell, Input::motor_current});
  scenario.temperatures = json.at("temperatures").get<bool>();
  scenario.specimens = json.at("specimens").get<std::size_t>();
  scenario.nominal = factors_of(json.at("nominal_over_true"));
  for (const Json& effect : json.at("hidden")) {
    scenario.hidden.push_back(effect_of(effect));
  }
  return scenario;
}

}  // namespace blind
