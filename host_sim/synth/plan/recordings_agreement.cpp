#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host_sim/synth/plan/agreement.hpp"
#include "host_sim/synth/plan/settings.hpp"

namespace host_sim::synth {
namespace {

constexpr double kMostSamples = 5e7;
constexpr double kFewestSamples = 10;

constexpr std::array kChannelsOfDrive{kMotorCurrentColumn, kMotorAngle, kWindingTemperature};

bool records(const RecordingPlan& plan, ProfileColumnId id) {
  return std::find(plan.channels.begin(), plan.channels.end(), id) != plan.channels.end();
}

void check_pull(const TomlTable& table, double mean_N, double amplitude_N) {
  if (amplitude_N >= mean_N) {
    table.fail(table.place_of("output_amplitudes_N"),
               fmt::format("an amplitude of {} N with a mean of {} N", amplitude_N, mean_N),
               "amplitudes below their means, for a tendon cannot push");
  }
}

/// @pre the lists of a listed design are of one length
void check_settings(const TomlTable& table, const RecordingPlan& plan) {
  const bool any_pair = plan.design != RecordingPlan::Design::listed;
  for (std::size_t i = 0; any_pair && i < plan.output_means_N.size(); ++i) {
    for (const double amplitude_N : plan.output_amplitudes_N) {
      check_pull(table, plan.output_means_N[i], amplitude_N);
    }
  }
  for (const Setting& setting : settings_of(plan, 0)) {
    check_pull(table, setting.output_mean_N, setting.output_amplitude_N);
    if (2 * setting.frequency_Hz * std::max(1.0, plan.motion.load_frequency_ratio) >
        plan.sample_rate_Hz) {
      table.fail(
          table.place_of("frequencies_Hz"),
          fmt::format("{} Hz at {} samples a second", setting.frequency_Hz, plan.sample_rate_Hz),
          "frequencies of motion and load up to half the sample rate");
    }
    if (setting.bend_angle_deg < plan.motion.pose_sway_deg ||
        setting.bend_angle_deg + plan.motion.pose_sway_deg > 1800) {
      table.fail(table.place_of("pose_sway_deg"),
                 fmt::format("a sway of {} deg about {} deg", plan.motion.pose_sway_deg,
                             setting.bend_angle_deg),
                 "bend angles that stay in 0..1800 deg");
    }
  }
}

void check_listed(const TomlTable& table, const RecordingPlan& plan) {
  if (plan.design != RecordingPlan::Design::listed) {
    return;
  }
  constexpr std::array<std::string_view, 8> kNames{
      "bend_angles_deg", "output_means_N",    "output_amplitudes_N", "frequencies_Hz",
      "travels_mm",      "sheath_ambients_C", "winding_starts_C",    "start_cycles"};
  const std::array sizes{plan.bend_angles_deg.size(),     plan.output_means_N.size(),
                         plan.output_amplitudes_N.size(), plan.frequencies_Hz.size(),
                         plan.travels_mm.size(),          plan.sheath_ambients_C.size(),
                         plan.winding_starts_C.size(),    plan.start_cycles.size()};
  const std::size_t most = *std::max_element(sizes.begin(), sizes.end());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] != 1 && sizes[i] != most) {
      table.fail(table.place_of(kNames[i]), fmt::format("{} values of {}", sizes[i], kNames[i]),
                 fmt::format("1 or {}, as the longest list of a listed design has", most));
    }
  }
}

void check_size(const TomlTable& table, const RecordingPlan& plan) {
  const std::size_t sessions = session_count(plan);
  const double samples = std::round(plan.duration_s * plan.sample_rate_Hz);
  if (sessions > kMostSessions || static_cast<double>(sessions) * samples > kMostSamples) {
    table.fail(
        table.place(), fmt::format("{} or more sessions of {} samples", sessions, samples),
        fmt::format("up to {} sessions, and {} samples together", kMostSessions, kMostSamples));
  }
  if (samples < kFewestSamples) {
    table.fail(table.place_of("duration_s"), fmt::format("{} samples a session", samples),
               fmt::format("at least {}", kFewestSamples));
  }
}

void check_channels(const TomlTable& top, const TomlTable& table, const SynthPlan& plan) {
  const RecordingPlan& recordings = *plan.recordings;
  const bool drives = plan.drive.has_value();
  for (const ProfileColumnId id : kChannelsOfDrive) {
    if (!drives && table.has("channels") && records(recordings, id)) {
      fail_for_model(top, "drive", profile_columns()[id].name);
    }
  }
  const bool has_input = records(recordings, kInputTensionColumn) ||
                         (drives && records(recordings, kMotorCurrentColumn));
  if (!has_input || !records(recordings, kOutputTensionColumn) ||
      !records(recordings, kTendonVelocity)) {
    table.fail(table.place_of("channels"), "channels that tell no friction",
               "input_tension_N or motor_current_A, with output_tension_N and tendon_velocity_m_s");
  }
}

}  // namespace

void check_recordings(const TomlTable& top, const SynthPlan& plan) {
  const TomlTable table = top.table("recordings");
  if (!plan.sheath) {
    fail_for_model(top, "sheath", "[recordings]");
  }
  check_listed(table, *plan.recordings);
  check_size(table, *plan.recordings);
  check_settings(table, *plan.recordings);
  check_channels(top, table, plan);
  if (plan.noise.clock_jitter_s * 3 * plan.recordings->sample_rate_Hz > 1) {
    const TomlTable noise = top.table("noise");
    noise.fail(noise.place_of("clock_jitter_s"),
               fmt::format("clock_jitter_s is {}", plan.noise.clock_jitter_s),
               "up to a third of the time between samples");
  }
}

}  // namespace host_sim::synth
