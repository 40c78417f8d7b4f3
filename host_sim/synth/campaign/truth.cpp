#include "host_sim/synth/campaign/truth.hpp"

#include <nlohmann/json.hpp>

namespace host_sim::synth {
namespace {

using Json = nlohmann::ordered_json;

Json of(const Hidden& hidden) {
  Json parameters = Json::object();
  for (const auto& [name, word] : hidden.values.words()) {
    parameters[name] = word;
  }
  for (const auto& [name, numbers] : hidden.values.numbers()) {
    parameters[name] = numbers.size() == 1 ? Json(numbers.front()) : Json(numbers);
  }
  return {{"id", hidden.id},
          {"data", hidden.of_life ? "lives" : "recordings"},
          {"parameters", std::move(parameters)}};
}

Json hidden_of(const SynthPlan& plan, bool outside) {
  Json list = Json::array();
  for (const Hidden& hidden : plan.hidden) {
    if (hidden.outside == outside) {
      list.push_back(of(hidden));
    }
  }
  return list;
}

Json noise_of(const Noise& noise) {
  return {{"log_tension_sd", noise.log_tension_sd},
          {"ar1", noise.ar1},
          {"student_t_dof", noise.student_t_dof},
          {"tension_resolution_N", noise.tension_resolution_N},
          {"current_resolution_A", noise.current_resolution_A},
          {"velocity_sd_m_s", noise.velocity_sd_m_s},
          {"velocity_resolution_m_s", noise.velocity_resolution_m_s},
          {"temperature_sd_C", noise.temperature_sd_C},
          {"clock_jitter_s", noise.clock_jitter_s},
          {"clock_drift_ppm", noise.clock_drift_ppm}};
}

Json sessions_of(const Truth& truth) {
  Json sessions = Json::array();
  for (std::size_t i = 0; i < truth.settings.size(); ++i) {
    const Setting& setting = truth.settings[i];
    sessions.push_back({{"pose", setting.pose},
                        {"bend_angle_deg", setting.bend_angle_deg},
                        {"bend_error_deg", truth.bend_errors_deg[i]},
                        {"output_mean_N", setting.output_mean_N},
                        {"output_amplitude_N", setting.output_amplitude_N},
                        {"frequency_Hz", setting.frequency_Hz},
                        {"travel_mm", setting.travel_mm},
                        {"sheath_ambient_C", setting.sheath_ambient_C},
                        {"winding_start_C", setting.winding_start_C},
                        {"start_cycle", setting.start_cycle},
                        {"log_gain", truth.scatter[i].log_gain},
                        {"friction_deviation", truth.scatter[i].friction}});
  }
  return sessions;
}

}  // namespace

std::string truth_json(const SynthPlan& plan, std::uint64_t seed, const Truth& truth) {
  const Json json{
      {"schema", 1},
      {"campaign", plan.name},
      {"seed", seed},
      {"effects", hidden_of(plan, false)},
      {"outside", hidden_of(plan, true)},
      {"scatter",
       {{"log_gain_sd", plan.scatter.log_gain_sd}, {"friction_sd", plan.scatter.friction_sd}}},
      {"noise", noise_of(plan.noise)},
      {"specimens", plan.lives ? plan.lives->specimens() : 0},
      {"sessions", sessions_of(truth)}};
  return json.dump(2) + "\n";
}

}  // namespace host_sim::synth
