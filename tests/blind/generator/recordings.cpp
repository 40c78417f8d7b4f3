#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/recordings_design.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/generator/toml_text.hpp"

namespace blind {
namespace {

constexpr double kTorqueConstant_Nm_per_A = 0.0325;
constexpr double kGearRatio = 9;
constexpr double kGearEfficiency = 0.88;
constexpr double kSpoolRadius_mm = 12.5;
constexpr double kRatedCurrent_A = 4;
constexpr double kFullScale_A = 8;

std::string model_text(const Scenario& scenario, double mu) {
  std::string text =
      "schema = 1\n" + table("campaign") + line("name", "blind-" + std::to_string(scenario.seed)) +
      table("model.sheath") + line("friction_coefficient", mu) + line("bend_angle_deg", 270.0);
  text += table("model.cable") + line("diameter_mm", 0.457) + line("ultimate_tension_N", 177.4);
  if (scenario.input == Input::motor_current) {
    text += table("model.drive") + line("torque_constant_Nm_per_A", kTorqueConstant_Nm_per_A) +
            line("gear_ratio", kGearRatio) + line("gear_efficiency", kGearEfficiency) +
            line("spool_radius_mm", kSpoolRadius_mm) + line("current_offset_A", 0.0);
  }
  return text;
}

std::vector<std::string> channels(const Scenario& scenario) {
  const bool drives = scenario.input == Input::motor_current;
  std::vector<std::string> names{"output_tension_N", "tendon_velocity_m_s", "bend_angle_deg"};
  names.emplace_back(drives ? "motor_current_A" : "input_tension_N");
  if (drives) {
    names.emplace_back("motor_angle_rad");
  }
  if (scenario.temperatures) {
    names.emplace_back("sheath_temperature_C");
  }
  if (scenario.temperatures && drives) {
    names.emplace_back("winding_temperature_C");
  }
  return names;
}

std::string recordings_text(const Scenario& scenario, const RecordingsDesign& design) {
  const bool crossed = scenario.design == Design::crossed;
  std::string text = table("recordings") + line("design", crossed ? "balanced" : "listed");
  if (crossed) {
    text += line("sessions", static_cast<double>(design.sessions));
  }
  text += line("bend_angles_deg", design.bend_angles_deg) +
          line("output_means_N", design.output_means_N) +
          line("output_amplitudes_N", design.output_amplitudes_N) +
          line("frequencies_Hz", design.frequencies_Hz) + line("travels_mm", design.travels_mm) +
          line("sheath_ambients_C", design.sheath_ambients_C) +
          line("winding_starts_C", design.winding_starts_C) +
          line("start_cycles", design.start_cycles);
  text += line("motion", design.constant_speed ? "constant_speed" : "sine") +
          line("load_frequency_ratio", design.load_frequency_ratio) +
          line("load_phase_deg", design.load_phase_deg) +
          line("pose_sway_deg", design.pose_sway_deg) + line("pose_sway_Hz", design.pose_sway_Hz) +
          line("sample_rate_Hz", design.sample_rate_Hz) + line("duration_s", design.duration_s) +
          line("channels", channels(scenario));
  return text;
}

/// Noise of sensors, and scatter of sessions up to half as much again as was measured.
std::string noise_text(std::uint64_t seed) {
  Dice dice(seed, Purpose::noise);
  std::string text = table("noise") + line("log_tension_sd", dice.log_between(0.005, 0.03)) +
                     line("ar1", dice.between(0, 0.95));
  if (dice.chance(0.5)) {
    text += line("student_t_dof", dice.between(3, 10));
  }
  text += line("tension_resolution_N", 0.01) + line("current_resolution_A", 0.001) +
          line("velocity_sd_m_s", 1e-4) + line("temperature_sd_C", dice.between(0.05, 0.5));
  text += table("scatter") + line("log_gain_sd", dice.log_between(0.002, 0.015)) +
          line("friction_sd", dice.log_between(0.001, 0.009));
  text += table("thermal") + line("sheath_K_per_W", dice.between(0, 2)) +
          line("winding_K_per_W", dice.between(0.3, 1));
  return text;
}

NominalFactors draw_nominal(std::uint64_t seed) {
  Dice dice(seed, Purpose::nominal);
  NominalFactors factors;
  factors.friction_coefficient = dice.between(0.85, 1.15);
  factors.torque_constant = dice.between(0.97, 1.03);
  return factors;
}

}  // namespace

Scenario draw_recordings(std::uint64_t seed) {
  const Choice choice = choose(seed);
  Scenario scenario;
  scenario.seed = seed;
  scenario.kind = choice.kind;
  scenario.design = choice.design;
  scenario.input = choice.input;
  scenario.temperatures = choice.temperatures;
  scenario.nominal = draw_nominal(seed);
  const RecordingsDesign design = draw_design(choice, seed);
  Dice dice(seed, Purpose::sizes);
  Situation situation;
  situation.input = choice.input;
  situation.friction_coefficient = dice.between(0.09, 0.15);
  situation.gear_efficiency = kGearEfficiency;
  situation.rated_torque_Nm = kRatedCurrent_A * kTorqueConstant_Nm_per_A;
  situation.full_scale_A = kFullScale_A;
  add_to(situation, design);
  scenario.plan = model_text(scenario, situation.friction_coefficient) +
                  recordings_text(scenario, design) + noise_text(seed);
  for (const SizedEffect& effect : choice.effects) {
    scenario.hidden.push_back(effect.draw(situation, dice));
    scenario.plan += table_of(scenario.hidden.back());
  }
  return scenario;
}

}  // namespace blind
