#include "host_sim/diagnose/output/results.hpp"

#include <utility>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/io/json.hpp"

namespace host_sim::diagnose {
namespace {

using nlohmann::ordered_json;

ordered_json text_or_null(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

/// A name that is there already gets a number, so that no value is lost.
std::string free_name(const ordered_json& json, const std::string& name) {
  std::string free = name;
  for (int i = 2; json.contains(free); ++i) {
    free = name + "_" + std::to_string(i);
  }
  return free;
}

ordered_json estimates_json(const std::vector<Estimate>& estimates) {
  ordered_json json = ordered_json::object();
  for (const Estimate& estimate : estimates) {
    json[free_name(json, estimate.name)] = {
        {"value", json_number(estimate.value)},
        {"ci95", ordered_json::array({json_number(estimate.low), json_number(estimate.high)})},
        {"unit", estimate.unit}};
  }
  return json;
}

ordered_json effect_json(const FoundEffect& effect) {
  return {{"id", effect.id},
          {"probability", json_number(effect.probability)},
          {"parameters", estimates_json(effect.parameters)},
          {"term", effect.term},
          {"equation", effect.equation},
          {"life_consequence", effect.life_consequence}};
}

ordered_json candidate_json(const Candidate& candidate) {
  return {{"id", candidate.id}, {"probability", json_number(candidate.probability)}};
}

ordered_json discrepancy_json(const Discrepancy& discrepancy) {
  return {{"covariate", discrepancy.covariate},
          {"statistic", json_number(discrepancy.statistic)},
          {"p", json_number(discrepancy.p)},
          {"p_after", json_number(discrepancy.p_after)}};
}

ordered_json gain_json(const HeldOutGain& gain) {
  ordered_json json{{"held_out_by", text_or_null(gain.held_out_by)}};
  for (const Metric& metric : gain.metrics) {
    json[free_name(json, metric.name)] = {{"before", json_number(metric.before)},
                                          {"after", json_number(metric.after)}};
  }
  return json;
}

ordered_json step_json(const Step& step) {
  return {{"effect", step.effect.id.empty() ? ordered_json(nullptr) : effect_json(step.effect)},
          {"output_rmse_N", json_number(step.output_rmse_N)},
          {"input_rmse_N", json_number(step.input_rmse_N)},
          {"log_predictive_density", json_number(step.log_predictive_density)},
          {"sessions_better", step.sessions_better},
          {"sessions", step.sessions}};
}

ordered_json remainder_json(const std::optional<Remainder>& remainder) {
  if (!remainder) {
    return nullptr;
  }
  return {{"share", json_number(remainder->share)},
          {"input_rmse_N", json_number(remainder->input_rmse_N)},
          {"output_rmse_N", json_number(remainder->output_rmse_N)},
          {"covariate", text_or_null(remainder->covariate)},
          {"p", json_number(remainder->p)}};
}

ordered_json correction_json(const std::optional<Correction>& correction) {
  if (!correction) {
    return nullptr;
  }
  return {{"covariate", correction->covariate},
          {"knots", correction->knots},
          {"input_rmse_N",
           {{"before", json_number(correction->before_N)},
            {"after", json_number(correction->after_N)}}}};
}

ordered_json extensions_json(const std::vector<Extension>& extensions) {
  ordered_json json = ordered_json::object();
  for (const Extension& extension : extensions) {
    ordered_json& table = json[free_name(json, extension.id)];
    table = ordered_json::object();
    for (const Extension::Value& value : extension.values) {
      const ordered_json values = json_list(value.values, json_number);
      table[value.name] = values.size() == 1 ? values.front() : values;
    }
  }
  return json;
}

ordered_json doubt_json(const Doubt& doubt) {
  return {{"sessions", doubt.sessions},
          {"column", text_or_null(doubt.column)},
          {"words", doubt.words},
          {"spoils", doubt.spoils}};
}

ordered_json findings_json(const Findings& findings) {
  return {{"verdict", name_of(findings.verdict)},
          {"words", findings.prose},
          {"doubts", json_list(findings.doubts, doubt_json)},
          {"effects", json_list(findings.effects, effect_json)},
          {"candidates", json_list(findings.candidates, candidate_json)},
          {"credible_set", findings.credible_set},
          {"equivalent_sets", findings.equivalent_sets},
          {"invisible", json_list(findings.invisible, [](const Invisible& one) { return one.id; })},
          {"invisible_because", json_list(findings.invisible,
                                          [](const Invisible& one) {
                                            return ordered_json{{"id", one.id}, {"why", one.why}};
                                          })},
          {"next_experiment", findings.next_experiment},
          {"gain", gain_json(findings.gain)},
          {"steps", json_list(findings.steps, step_json)},
          {"discrepancy", json_list(findings.discrepancies, discrepancy_json)},
          {"refitted", estimates_json(findings.refitted)},
          {"extensions", extensions_json(findings.extensions)}};
}

ordered_json tension_json(const std::optional<TensionDiagnosis>& tension) {
  if (!tension) {
    return nullptr;
  }
  ordered_json json = findings_json(tension->findings);
  json["remainder"] = remainder_json(tension->findings.remainder);
  json["correction"] = correction_json(tension->findings.correction);
  json["damage_ratio"] = json_number(tension->damage_ratio);
  json["friction_coefficient"] = json_number(tension->friction_coefficient);
  json["log_gain"] = json_number(tension->log_gain);
  return json;
}

ordered_json lives_json(const std::optional<LifeDiagnosis>& lives) {
  if (!lives) {
    return nullptr;
  }
  ordered_json json = findings_json(lives->findings);
  json["b10_ratio"] = json_number(lives->b10_ratio);
  json["ipl_scale"] = json_number(lives->ipl_scale);
  json["ipl_exponent"] = json_number(lives->ipl_exponent);
  json["weibull_shape"] = json_number(lives->weibull_shape);
  json["residual_shape"] = {{"before", json_number(lives->picture.shape_before)},
                            {"after", json_number(lives->picture.shape_after)}};
  return json;
}

}  // namespace

std::string diagnosis_json(const Diagnosis& diagnosis, const ResultsContext& context, int indent) {
  ordered_json json{{"campaign", context.campaign}};
  const Findings all = merged(diagnosis);
  json.update(findings_json(all));
  json["remainder"] = remainder_json(all.remainder);
  json["correction"] = correction_json(all.correction);
  json["extended_model"] = text_or_null(context.extended_model);
  json["tension"] = tension_json(diagnosis.tension);
  json["lives"] = lives_json(diagnosis.lives);
  json["warnings"] = diagnosis.warnings;
  json["seed"] = context.seed;
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace host_sim::diagnose
