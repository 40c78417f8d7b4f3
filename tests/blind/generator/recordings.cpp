#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "tests/blind/generator/choice.hpp"
#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/generator/sized_effect.hpp"

namespace blind {
namespace {

/// What sessions are run at, as [recordings] of a plan has it.
struct RecordingsDesign {
  std::size_t sessions = 0;
  std::vector<double> bend_angles_deg, output_means_N, output_amplitudes_N, frequencies_Hz,
      travels_mm, sheath_ambients_C, winding_starts_C, start_cycles;
  double load_frequency_ratio = 1, load_phase_deg = 0;
  double pose_sway_deg = 0, pose_sway_Hz = 0.1;
  bool constant_speed = false;
  double sample_rate_Hz = 0, duration_s = 0;
};

constexpr double kRoom_C = 20;

void draw_motion(const Choice& choice, Dice& dice, RecordingsDesign& design) {
  const bool must_sway =
      std::any_of(choice.effects.begin(), choice.effects.end(),
                  [](const SizedEffect& effect) { return effect.id == "load_cell_cross_talk"; });
  design.load_frequency_ratio = dice.between(1.15, 1.85);
  design.load_phase_deg = dice.between(0, 360);
  design.constant_speed = dice.chance(0.25);
  if (dice.chance(0.2) || must_sway) {
    design.pose_sway_deg = dice.between(5, 20);
    design.pose_sway_Hz = dice.between(0.1, 0.4);
  }
  design.sample_rate_Hz = dice.chance(0.5) ? 100 : 200;
  design.duration_s = std::round(dice.between(8, 20));
}

void draw_crossed(const Choice& choice, Dice& dice, RecordingsDesign& design) {
  design.sessions = 12 + dice.below(25);
  design.bend_angles_deg = {dice.between(60, 100), dice.between(160, 240), dice.between(300, 390)};
  design.output_means_N = {dice.between(12, 20), dice.between(30, 40)};
  design.output_amplitudes_N = {dice.between(2, 5), dice.between(7, 11)};
  design.frequencies_Hz = {dice.between(0.2, 0.4), dice.between(0.7, 1.2), dice.between(1.6, 2.5)};
  design.travels_mm = {dice.between(15, 25), dice.between(35, 50)};
  design.start_cycles = {0, dice.between(300, 700), dice.between(1500, 3000),
                         dice.between(6000, 10000)};
  design.sheath_ambients_C = {kRoom_C};
  design.winding_starts_C = {kRoom_C};
  if (choice.temperatures) {
    design.sheath_ambients_C.push_back(dice.between(40, 55));
    design.winding_starts_C.push_back(dice.between(60, 90));
  }
}

void draw_one_pose(Dice& dice, RecordingsDesign& design) {
  design.sessions = 12 + dice.below(25);
  design.bend_angles_deg = {dice.between(180, 300)};
  design.travels_mm = {dice.between(25, 45)};
  const double cycles_between = dice.between(200, 500);
  const double warmer_K = dice.between(5, 20);
  const std::vector<double> frequencies_Hz{dice.between(0.3, 0.6), dice.between(0.8, 1.5)};
  for (std::size_t i = 0; i < design.sessions; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(design.sessions - 1);
    design.start_cycles.push_back(std::round(static_cast<double>(i) * cycles_between));
    design.sheath_ambients_C.push_back(kRoom_C + warmer_K * share + dice.between(-1, 1));
    design.winding_starts_C.push_back(dice.between(20, 60));
    design.output_means_N.push_back(dice.between(20, 35));
    design.output_amplitudes_N.push_back(dice.between(4, 12));
    design.frequencies_Hz.push_back(dice.one_of(frequencies_Hz));
  }
}

double middle_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double most_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// 12 .. 36 sessions of 8 .. 20 s. Crossed: two or three poses, loads, speeds, temperatures and
/// cycles, dealt out apart from each other. In one pose: one session after the other in a tendon's
/// life, warmer from month to month.
RecordingsDesign draw_design(const Choice& choice, std::uint64_t seed) {
  Dice dice(seed, Purpose::design);
  RecordingsDesign design;
  draw_motion(choice, dice, design);
  if (choice.design == Design::crossed) {
    draw_crossed(choice, dice, design);
  } else {
    draw_one_pose(dice, design);
  }
  return design;
}

/// What the design says about sizes; what it does not know stays.
void add_to(TensionScales& scales, const RecordingsDesign& design) {
  scales.mean_tension_N = middle_of(design.output_means_N);
  scales.shortest_travel_mm = *std::min_element(design.travels_mm.begin(), design.travels_mm.end());
  scales.last_cycle = most_of(design.start_cycles);
  scales.fastest_m_s =
      std::numbers::pi * most_of(design.frequencies_Hz) * most_of(design.travels_mm) * 1e-3;
  scales.poses = design.bend_angles_deg.size();
}

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

/// What is not in proportion to the reading.
std::string floor_text(Input input, Dice& dice) {
  constexpr double kSmallest_N = 0.01;
  constexpr double kLargest_N = 0.2;
  constexpr double kAmperes_N =
      kSpoolRadius_mm * 1e-3 / (kGearRatio * kGearEfficiency * kTorqueConstant_Nm_per_A);
  const double output_N = dice.log_between(kSmallest_N, kLargest_N);
  const double input_N = dice.log_between(kSmallest_N, kLargest_N);
  return line("output_absolute_N", output_N) +
         (input == Input::load_cell ? line("input_absolute_N", input_N)
                                    : line("input_absolute_A", input_N * kAmperes_N));
}

/// Noise in proportion to the reading.
struct Relative {
  double sd = 0;
  double ar1 = 0;
};

Relative draw_relative(double least_sd, double most_sd, Dice& dice) {
  const double sd = dice.log_between(least_sd, most_sd);
  const double ar1 = dice.between(0, 0.95);
  return {sd, dice.chance(0.5) ? 0 : ar1};
}

/// Noise of both ends: a good sensor at the load and a worse one at the drive, the other way about,
/// or alike.
std::string ends_text(Input input, const Relative& alike, std::uint64_t seed) {
  Dice dice(seed, Purpose::ends);
  const std::size_t better = dice.below(3);
  const Relative good = draw_relative(0.001, 0.01, dice);
  const Relative worse = draw_relative(0.005, 0.02, dice);
  const Relative& output = better == 2 ? alike : better == 0 ? good : worse;
  const Relative& at_drive = better == 2 ? alike : better == 1 ? good : worse;
  std::string text = line("output_relative_sd", output.sd) + line("output_ar1", output.ar1) +
                     line("input_relative_sd", at_drive.sd) + line("input_ar1", at_drive.ar1) +
                     floor_text(input, dice);
  const double jitter_s = dice.log_between(1e-4, 1e-3);
  return dice.chance(1.0 / 3) ? text + line("jitter_s", jitter_s) : text;
}

/// Noise of sensors, and scatter of sessions up to half as much again as was measured.
std::string noise_text(Input input, std::uint64_t seed) {
  Dice dice(seed, Purpose::noise);
  const double alike_sd = dice.log_between(0.005, 0.03);
  const double alike_ar1 = dice.between(0, 0.95);
  std::string text = table("noise") + ends_text(input, {alike_sd, alike_ar1}, seed);
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

NominalFactors nominal_friction_and_drive(std::uint64_t seed) {
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
  scenario.nominal = nominal_friction_and_drive(seed);
  const RecordingsDesign design = draw_design(choice, seed);
  Dice dice(seed, Purpose::sizes);
  TensionScales scales;
  scales.input = choice.input;
  scales.friction_coefficient = dice.between(0.09, 0.15);
  scales.gear_efficiency = kGearEfficiency;
  scales.rated_torque_Nm = kRatedCurrent_A * kTorqueConstant_Nm_per_A;
  scales.full_scale_A = kFullScale_A;
  add_to(scales, design);
  scenario.plan = model_text(scenario, scales.friction_coefficient) +
                  recordings_text(scenario, design) + noise_text(choice.input, seed);
  for (const SizedEffect& effect : choice.effects) {
    scenario.hidden.push_back(effect.draw(scales, dice));
    scenario.plan += table_of(scenario.hidden.back());
  }
  return scenario;
}

}  // namespace blind
