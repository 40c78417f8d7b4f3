#include "tests/blind/records/record.hpp"

#include <nlohmann/json.hpp>

#include "tests/blind/making/make.hpp"
#include "tests/blind/records/verdict_words.hpp"

namespace blind {
namespace {

using Json = nlohmann::ordered_json;
using host_sim::diagnose::Candidate;
using host_sim::diagnose::Estimate;
using host_sim::diagnose::Findings;
using host_sim::diagnose::FoundEffect;
using host_sim::diagnose::Metric;

Json json_of(const FoundEffect& effect) {
  Json parameters = Json::array();
  for (const Estimate& estimate : effect.parameters) {
    parameters.push_back({{"name", estimate.name},
                          {"value", estimate.value},
                          {"low", estimate.low},
                          {"high", estimate.high}});
  }
  return {{"id", effect.id},
          {"probability", effect.probability},
          {"parameters", std::move(parameters)}};
}

FoundEffect effect_of(const Json& json) {
  FoundEffect effect;
  effect.id = json.at("id").get<std::string>();
  effect.probability = json.at("probability").get<double>();
  for (const Json& parameter : json.at("parameters")) {
    Estimate estimate;
    estimate.name = parameter.at("name").get<std::string>();
    estimate.value = parameter.at("value").get<double>();
    estimate.low = parameter.at("low").get<double>();
    estimate.high = parameter.at("high").get<double>();
    effect.parameters.push_back(std::move(estimate));
  }
  return effect;
}

Json json_of(const Findings& findings) {
  Json effects = Json::array();
  for (const FoundEffect& effect : findings.effects) {
    effects.push_back(json_of(effect));
  }
  Json candidates = Json::array();
  for (const Candidate& candidate : findings.candidates) {
    candidates.push_back({{"id", candidate.id}, {"probability", candidate.probability}});
  }
  Json gain = Json::array();
  for (const Metric& metric : findings.gain.metrics) {
    gain.push_back({{"name", metric.name}, {"before", metric.before}, {"after", metric.after}});
  }
  return {{"verdict", verdict_word(findings.verdict)},
          {"effects", std::move(effects)},
          {"candidates", std::move(candidates)},
          {"credible_set", findings.credible_set},
          {"equivalent_sets", findings.equivalent_sets},
          {"held_out_by", findings.gain.held_out_by},
          {"gain", std::move(gain)}};
}

Findings findings_of(const Json& json) {
  Findings findings;
  findings.verdict = verdict_named(json.at("verdict").get<std::string>());
  for (const Json& effect : json.at("effects")) {
    findings.effects.push_back(effect_of(effect));
  }
  for (const Json& candidate : json.at("candidates")) {
    findings.candidates.push_back(
        {candidate.at("id").get<std::string>(), candidate.at("probability").get<double>()});
  }
  findings.credible_set = json.at("credible_set").get<std::vector<std::string>>();
  findings.equivalent_sets =
      json.at("equivalent_sets").get<std::vector<std::vector<std::string>>>();
  findings.gain.held_out_by = json.at("held_out_by").get<std::string>();
  for (const Json& metric : json.at("gain")) {
    findings.gain.metrics.push_back({metric.at("name").get<std::string>(),
                                     metric.at("before").get<double>(),
                                     metric.at("after").get<double>()});
  }
  return findings;
}

}  // namespace

std::string line_of(const Record& record) {
  const Json json{{"truth", Json::parse(truth_text(record.truth, ""))},
                  {"truth_sha256", record.truth_sha256},
                  {"visibility", record.visibility},
                  {"rmse_floor_N", record.rmse_floor_N},
                  {"findings", json_of(record.findings)},
                  {"error", record.error},
                  {"seconds", record.seconds}};
  return json.dump();
}

Record record_of(const std::string& line) {
  const Json json = Json::parse(line);
  Record record;
  record.truth = scenario_of(json.at("truth").dump());
  record.truth_sha256 = json.at("truth_sha256").get<std::string>();
  record.visibility = json.at("visibility").get<std::vector<double>>();
  record.rmse_floor_N = json.value("rmse_floor_N", 0.0);
  record.findings = findings_of(json.at("findings"));
  record.error = json.at("error").get<std::string>();
  record.seconds = json.at("seconds").get<double>();
  return record;
}

}  // namespace blind
