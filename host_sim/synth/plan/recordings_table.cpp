#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "host_sim/synth/plan/plan.hpp"
#include "host_sim/synth/plan/tables.hpp"

namespace host_sim::synth {

using hal::files::describe;
using enum hal::files::ProfileColumnId;
using hal::files::NumberKey;
using hal::files::profile_column_names;
using hal::files::profile_columns;
using hal::files::ProfileColumn;
using hal::files::ProfileColumnId;
using hal::files::TomlTable;

namespace {

constexpr NumberKey kBendAngles{"bend_angles_deg", "deg", {0, 1800}};
constexpr NumberKey kMeans{"output_means_N", "N", {0, 1e6, true}};
constexpr NumberKey kSignedMeans{"output_means_N", "N", {-1e6, 1e6}};
constexpr NumberKey kAmplitudes{"output_amplitudes_N", "N", {0, 1e6}};
constexpr NumberKey kFrequencies{"frequencies_Hz", "Hz", {0.001, 50}};
constexpr NumberKey kTravels{"travels_mm", "mm", {0.01, 1000}};
constexpr NumberKey kAmbients{"sheath_ambients_C", "C", {-50, 200}};
constexpr NumberKey kWindingStarts{"winding_starts_C", "C", {-50, 200}};
constexpr NumberKey kStartCycles{"start_cycles", "cycles", {0, 1e12}};
constexpr NumberKey kSessions{"sessions", "", {1, 10'000}};
constexpr NumberKey kRepeats{"repeats", "", {1, 1000}};
constexpr NumberKey kSampleRate{"sample_rate_Hz", "Hz", {1, 10'000}};
constexpr NumberKey kDuration{"duration_s", "s", {0.01, 100'000}};
constexpr NumberKey kLoadPhase{"load_phase_deg", "deg", {-360, 360}};
constexpr NumberKey kLoadRatio{"load_frequency_ratio", "", {0.01, 100}};
constexpr NumberKey kSway{"pose_sway_deg", "deg", {0, 180}};
constexpr NumberKey kSwayFrequency{"pose_sway_Hz", "Hz", {0.001, 50}};
constexpr NumberKey kInterval{"session_interval_h", "h", {0, 10'000}};

constexpr std::array kNumbers{kBendAngles,    kMeans,         kAmplitudes,  kFrequencies, kTravels,
                              kAmbients,      kWindingStarts, kStartCycles, kSessions,    kRepeats,
                              kSampleRate,    kDuration,      kLoadPhase,   kLoadRatio,   kSway,
                              kSwayFrequency, kInterval};
constexpr std::array<std::string_view, 3> kOthers{"design", "motion", "channels"};
constexpr std::array<std::string_view, 3> kDesigns{"crossed", "listed", "balanced"};
constexpr std::array<std::string_view, 2> kForms{"sine", "constant_speed"};

ProfileColumnId channel_named(const TomlTable& table, const toml::node& node,
                              std::string_view accepted) {
  const auto columns = profile_columns();
  const auto* const text = node.as_string();
  const auto found = std::find_if(
      columns.begin() + 1, columns.end(),
      [&](const ProfileColumn& column) { return text != nullptr && column.name == text->get(); });
  if (found == columns.end()) {
    table.fail(node.source().begin, fmt::format("channels holds {}", describe(node)), accepted);
  }
  return static_cast<ProfileColumnId>(found - columns.begin());
}

/// All channels where the table leaves them out.
std::vector<ProfileColumnId> channels_in(const TomlTable& table) {
  std::vector<ProfileColumnId> channels{kTime};
  if (!table.has("channels")) {
    for (unsigned id = kTime + 1; id < kProfileColumnCount; ++id) {
      channels.push_back(static_cast<ProfileColumnId>(id));
    }
    return channels;
  }
  const std::string accepted = "channels as a list of different names of " + profile_column_names();
  const toml::node& node = table.node("channels", accepted);
  const toml::array* const array = node.as_array();
  if (array == nullptr) {
    table.fail(table.place_of("channels"), fmt::format("channels is {}", describe(node)), accepted);
  }
  for (const toml::node& element : *array) {
    const ProfileColumnId id = channel_named(table, element, accepted);
    if (std::find(channels.begin(), channels.end(), id) != channels.end()) {
      table.fail(element.source().begin, fmt::format("channel {} twice", describe(element)),
                 accepted);
    }
    channels.push_back(id);
  }
  std::sort(channels.begin(), channels.end());
  return channels;
}

Motion motion_in(const TomlTable& table) {
  Motion motion;
  motion.form = static_cast<Motion::Form>(choice_of(table, "motion", kForms));
  motion.load_phase_deg = number_or(table, kLoadPhase, motion.load_phase_deg);
  motion.load_frequency_ratio = number_or(table, kLoadRatio, motion.load_frequency_ratio);
  motion.pose_sway_deg = number_or(table, kSway, motion.pose_sway_deg);
  motion.pose_sway_Hz = number_or(table, kSwayFrequency, motion.pose_sway_Hz);
  motion.session_interval_h = number_or(table, kInterval, motion.session_interval_h);
  return motion;
}

void read_sessions(const TomlTable& table, RecordingPlan& plan) {
  plan.design = static_cast<RecordingPlan::Design>(choice_of(table, "design", kDesigns));
  const bool balanced = plan.design == RecordingPlan::Design::balanced;
  if (balanced != table.has(kSessions.name)) {
    table.fail(table.place_of(balanced ? "design" : kSessions.name),
               balanced ? "a balanced design without sessions"
                        : "sessions beside a design that is not balanced",
               "design = \"balanced\" with a number of sessions");
  }
  plan.sessions = whole_or(table, kSessions, 0);
  plan.repeats = whole_or(table, kRepeats, 1);
}

}  // namespace

RecordingPlan recordings_in(const TomlTable& table, bool two_sided) {
  constexpr double kRoom_C = 20;
  table.refuse_unknown_keys(kNumbers, kOthers);
  RecordingPlan plan;
  read_sessions(table, plan);
  plan.bend_angles_deg = numbers(table, kBendAngles);
  plan.output_means_N = numbers(table, two_sided ? kSignedMeans : kMeans);
  plan.output_amplitudes_N = numbers(table, kAmplitudes);
  plan.frequencies_Hz = numbers(table, kFrequencies);
  plan.travels_mm = numbers(table, kTravels);
  plan.sheath_ambients_C = numbers_or(table, kAmbients, kRoom_C);
  plan.winding_starts_C = numbers_or(table, kWindingStarts, kRoom_C);
  plan.start_cycles = numbers_or(table, kStartCycles, 0);
  plan.sample_rate_Hz = table.number(kSampleRate);
  plan.duration_s = table.number(kDuration);
  plan.motion = motion_in(table);
  plan.channels = channels_in(table);
  return plan;
}

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
void check_settings(const TomlTable& table, const RecordingPlan& plan, bool two_sided) {
  const bool any_pair = !two_sided && plan.design != RecordingPlan::Design::listed;
  for (std::size_t i = 0; any_pair && i < plan.output_means_N.size(); ++i) {
    for (const double amplitude_N : plan.output_amplitudes_N) {
      check_pull(table, plan.output_means_N[i], amplitude_N);
    }
  }
  for (const Setting& setting : settings_of(plan, 0)) {
    if (!two_sided) {
      check_pull(table, setting.output_mean_N, setting.output_amplitude_N);
    }
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
  const bool drives = plan.model.drive.has_value();
  for (const ProfileColumnId id : kChannelsOfDrive) {
    if (!drives && table.has("channels") && records(recordings, id)) {
      fail_for_model(top, "drive", profile_columns()[id].name);
    }
  }
  const bool has_input = records(recordings, kInputTensionColumn) ||
                         (drives && records(recordings, kMotorCurrentColumn));
  if (!has_input || !records(recordings, kOutputTensionColumn) ||
      !records(recordings, kTendonVelocity)) {
    table.fail(table.place_of("channels"), "channels that show no friction",
               "input_tension_N or motor_current_A, with output_tension_N and tendon_velocity_m_s");
  }
}

void check_jitter(const TomlTable& top, std::string_view key, double jitter_s,
                  const RecordingPlan& plan) {
  if (jitter_s * 3 * plan.sample_rate_Hz > 1) {
    const TomlTable noise = top.table("noise");
    noise.fail(noise.place_of(key), fmt::format("{} is {}", key, jitter_s),
               "up to a third of the time between samples");
  }
}

}  // namespace

void check_recordings(const TomlTable& top, const SynthPlan& plan) {
  const TomlTable table = top.table("recordings");
  if (!plan.model.sheath) {
    fail_for_model(top, "sheath", "[recordings]");
  }
  check_listed(table, *plan.recordings);
  check_size(table, *plan.recordings);
  check_settings(table, *plan.recordings, plan.two_sided);
  check_channels(top, table, plan);
  check_jitter(top, "clock_jitter_s", plan.noise.clock_jitter_s, *plan.recordings);
  check_jitter(top, "jitter_s", plan.noise.jitter_s, *plan.recordings);
}

}  // namespace host_sim::synth
