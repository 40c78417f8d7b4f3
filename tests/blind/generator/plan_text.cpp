#include "tests/blind/generator/plan_text.hpp"

#include "tests/blind/generator/dice.hpp"

namespace blind {
namespace {

constexpr double kTorqueConstant_Nm_per_A = 0.0325;
constexpr double kGearRatio = 9;
constexpr double kSpoolRadius_mm = 12.5;

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

}  // namespace

std::string model_text(const Scenario& scenario, double mu) {
  std::string text =
      "schema = 1\n" + table("campaign") + line("name", "blind-" + std::to_string(scenario.seed)) +
      (scenario.design == Design::two_sided ? "two_sided = true\n" : "") + table("model.sheath") +
      line("friction_coefficient", mu) + line("bend_angle_deg", 270.0);
  text += table("model.cable") + line("diameter_mm", 0.457) + line("ultimate_tension_N", 177.4);
  if (scenario.input == Input::motor_current) {
    text += table("model.drive") + line("torque_constant_Nm_per_A", kTorqueConstant_Nm_per_A) +
            line("gear_ratio", kGearRatio) + line("gear_efficiency", kGearEfficiency) +
            line("spool_radius_mm", kSpoolRadius_mm) + line("current_offset_A", 0.0);
  }
  return text;
}

std::string recordings_text(const Scenario& scenario, const RecordingsDesign& design) {
  const bool crossed = scenario.design != Design::one_pose;
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

}  // namespace blind
