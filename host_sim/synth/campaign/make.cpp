#include "host_sim/synth/campaign/make.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "hal/files/output_file.hpp"
#include "host_sim/model/model_tables.hpp"
#include "host_sim/model/watch.hpp"
#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/campaign/sessions.hpp"

namespace host_sim::synth {

using hal::files::write_file;

Truth make_campaign(const SynthPlan& plan, const MakeOptions& options,
                    const std::filesystem::path& folder) {
  write_file(folder / "campaign.toml", campaign_text(plan));
  if (plan.lives) {
    const LifeTexts texts = life_texts(plan, options.seed);
    write_file(folder / "specimens.csv", texts.specimens);
    if (!texts.blocks.empty()) {
      write_file(folder / "blocks.csv", texts.blocks);
    }
  }
  return plan.recordings ? write_sessions(plan, options, folder) : Truth{};
}

namespace {

/// A text of visible characters as a TOML string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  result += '"';
  return result;
}

bool has_table(const SynthPlan& plan, std::string_view table) {
  return (table == "cable" && plan.model.cable) || (table == "sheath" && plan.model.sheath) ||
         (table == "drive" && plan.model.drive) || (table == "counting" && plan.model.counting) ||
         (table == "life" && plan.model.life);
}

Model model_of(const SynthPlan& plan) {
  Model model{};
  if (plan.model.cable) {
    model.cable = *plan.model.cable;
  }
  if (plan.model.sheath) {
    model.sheath = *plan.model.sheath;
  }
  if (plan.model.drive) {
    model.drive = *plan.model.drive;
  }
  if (plan.model.counting) {
    model.counting = *plan.model.counting;
  }
  if (plan.model.life) {
    model.life = *plan.model.life;
  }
  return model;
}

}  // namespace

std::string campaign_text(const SynthPlan& plan) {
  Model model = model_of(plan);
  std::string text = fmt::format("schema = 1\n\n[campaign]\nname = {}\n{}", quoted(plan.name),
                                 plan.two_sided ? "two_sided = true\n" : "");
  std::string_view table;
  for (const ModelKey& key : model_keys()) {
    if (!has_table(plan, key.table)) {
      continue;
    }
    if (table != key.table) {
      table = key.table;
      fmt::format_to(std::back_inserter(text), "\n[model.{}]\n", table);
      if (table == "life") {
        fmt::format_to(std::back_inserter(text), "mean_stress = \"{}\"\n",
                       name_of(model.life.mean_stress));
      }
    }
    fmt::format_to(std::back_inserter(text), "{} = {}\n", key.key, key.value(model));
  }
  if (plan.model.watch) {
    text += "\n[model.watch]\n" + watch_text(*plan.model.watch, "");
  }
  return text;
}

namespace {

using Json = nlohmann::ordered_json;

Json of(const Departure& departure) {
  Json parameters = Json::object();
  for (const auto& [name, word] : departure.values.choices()) {
    parameters[name] = word;
  }
  for (const auto& [name, numbers] : departure.values.numbers()) {
    parameters[name] = numbers.size() == 1 ? Json(numbers.front()) : Json(numbers);
  }
  return {{"id", departure.id},
          {"data", departure.of_life ? "lives" : "recordings"},
          {"parameters", std::move(parameters)}};
}

Json hidden_of(const SynthPlan& plan, bool outside) {
  Json list = Json::array();
  for (const Departure& departure : plan.departures) {
    if (departure.outside == outside) {
      list.push_back(of(departure));
    }
  }
  return list;
}

Json noise_of(const EndNoise& end) {
  return {{"relative_sd", end.relative_sd},
          {"absolute_N", end.absolute_N},
          {"absolute_A", end.absolute_A},
          {"ar1", end.ar1}};
}

Json noise_of(const Noise& noise) {
  return {{"output", noise_of(noise.output)},
          {"input", noise_of(noise.input)},
          {"jitter_s", noise.jitter_s},
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

std::string sha256(std::string_view text) {
  std::array<unsigned char, 32> digest{};
  if (EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available");
  }
  std::string digits;
  for (const unsigned char byte : digest) {
    fmt::format_to(std::back_inserter(digits), "{:02x}", byte);
  }
  return digits;
}

}  // namespace host_sim::synth
