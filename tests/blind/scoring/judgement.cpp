#include "tests/blind/scoring/judgement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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

std::vector<std::string> ids_in(const std::string& joined) {
  std::vector<std::string> ids;
  std::istringstream text(joined);
  for (std::string id; std::getline(text, id, '+');) {
    ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool holds(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

class Values {
 public:
  explicit Values(const HiddenEffect& effect) : effect_(effect) {}

  double operator()(const std::string& name) const { return effect_.numbers.at(name).front(); }
  [[nodiscard]] bool has(const std::string& name) const { return effect_.numbers.contains(name); }
  [[nodiscard]] bool says(const std::string& name, const std::string& word) const {
    const auto found = effect_.texts.find(name);
    return found != effect_.texts.end() && found->second == word;
  }

 private:
  const HiddenEffect& effect_;
};

/// The catalogue's mu (1 + a (n / 1000)^p) against mu (1 + c (n / n_0)^p).
std::vector<TrueParameter> of_wear(const Values& values) {
  if (values.says("law", "run_in")) {
    return {{"wear_coefficient", values("change")}, {"run_in_cycles", values("reference_cycles")}};
  }
  constexpr double kCatalogueCycles = 1000;
  const double exponent = values("exponent");
  return {{"wear_coefficient",
           values("change") * std::pow(kCatalogueCycles / values("reference_cycles"), exponent)},
          {"wear_exponent", exponent}};
}

/// The static coefficient depends on mu, which is refitted.
std::vector<TrueParameter> of_velocity(const Values& values) {
  if (values.has("viscous_N_s_m")) {
    return {{"viscous_N_s_m", values("viscous_N_s_m")}};
  }
  const double viscous_s_m = values("viscous_s_m");
  if (viscous_s_m != 0) {
    return {{"viscous_friction_s_m", viscous_s_m}};
  }
  return {{"stribeck_velocity_m_s", values("stribeck_velocity_mm_s") * 1e-3}};
}

std::vector<TrueParameter> of_sensors(const std::string& id, const Values& values) {
  if (id == "current_offset") {
    return {{"current_offset_A", values("offset_A")}};
  }
  const double sign = values.says("sensor", "output_tension") ? 1 : -1;
  if (id == "filter_lag") {
    return {{"lag_s", sign * values("time_constant_ms") * 1e-3}};
  }
  if (id == "channel_delay") {
    return {{"delay_s", sign * values("delay_ms") * 1e-3}};
  }
  if (id == "gear_asymmetry") {
    const double pulling = values("pulling_efficiency");
    const double releasing = values("releasing_efficiency");
    return {{"gear_asymmetry", (pulling - releasing) / (pulling + releasing)}};
  }
  if (id == "load_cell_zero") {
    return {{"load_cell_zero_N", values("zero_N")}};
  }
  if (id == "torque_gain") {
    return {{"droop_1_K", values("droop_1_K")}};
  }
  return {};
}

std::vector<TrueParameter> of_lives(const std::string& id, const Values& values) {
  if (id == "ageing") {
    return {{"ageing_1_day", values("rate_1_day")}};
  }
  if (id == "load_sequence") {
    return {{"sequence_exponent", values("exponent")}};
  }
  if (id == "mean_stress" && values.says("law", "walker")) {
    return {{"walker_exponent", values("walker_exponent")}};
  }
  return {};
}

}  // namespace

std::string Judgement::first() const {
  const Candidate* const candidate = most_probable(record_);
  return candidate == nullptr ? "" : fmt::format("{}", fmt::join(ids_in(candidate->id), "+"));
}

double Judgement::first_probability() const {
  const Candidate* const candidate = most_probable(record_);
  return candidate == nullptr ? 0 : candidate->probability;
}

bool Judgement::first_is_hidden() const {
  const std::vector<std::string> ids = ids_in(first());
  return !ids.empty() &&
         std::all_of(ids.begin(), ids.end(), [&](const std::string& id) { return hides(id); });
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

std::vector<TrueParameter> true_parameters(const HiddenEffect& effect) {
  const Values values(effect);
  const std::string& id = effect.id;
  if (id == "compliance") {
    return {{"stiffness_N_m", values("stiffness_N_mm") * 1e3},
            {"compliance_m_N", 1e-3 / values("stiffness_N_mm")}};
  }
  if (id == "friction_load") {
    return {{"load_exponent", values("exponent")}};
  }
  if (id == "friction_preload") {
    return {{"preload_N", values("force_N")}};
  }
  if (id == "friction_temperature") {
    return {{"temperature_coefficient_1_K", values("slope_1_K")}};
  }
  if (id == "friction_velocity") {
    return of_velocity(values);
  }
  if (id == "friction_wear") {
    return of_wear(values);
  }
  if (id == "presliding") {
    return {{"presliding_length_m", values("length_mm") * 1e-3}};
  }
  if (id == "slack") {
    std::vector<TrueParameter> slack{{"slack_m", values("dead_zone_mm") * 1e-3}};
    if (values.has("held_share")) {
      slack.push_back({"slack_log_drop", -std::log(values("held_share"))});
    }
    return slack;
  }
  std::vector<TrueParameter> found = of_sensors(id, values);
  return found.empty() ? of_lives(id, values) : found;
}

std::vector<ParameterScore> score_parameters(const std::vector<TrueParameter>& truth,
                                             const host_sim::diagnose::FoundEffect& found) {
  std::vector<ParameterScore> scores;
  for (const TrueParameter& parameter : truth) {
    for (const auto& estimate : found.parameters) {
      if (estimate.name == parameter.name) {
        scores.push_back({std::abs(estimate.value - parameter.value) / std::abs(parameter.value),
                          estimate.low <= parameter.value && parameter.value <= estimate.high});
      }
    }
  }
  return scores;
}

}  // namespace blind
