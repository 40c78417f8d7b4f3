#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "host_sim/synth/plan/tables.hpp"
#include "host_sim/synth/plan/toml_values.hpp"

namespace host_sim::synth {
namespace {

constexpr NumberKey kBendAngles{"bend_angles_deg", "deg", {0, 1800}};
constexpr NumberKey kMeans{"output_means_N", "N", {0, 1000, true}};
constexpr NumberKey kAmplitudes{"output_amplitudes_N", "N", {0, 1000}};
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
  motion.form = static_cast<Motion::Form>(word(table, "motion", kForms));
  motion.load_phase_deg = number_or(table, kLoadPhase, motion.load_phase_deg);
  motion.load_frequency_ratio = number_or(table, kLoadRatio, motion.load_frequency_ratio);
  motion.pose_sway_deg = number_or(table, kSway, motion.pose_sway_deg);
  motion.pose_sway_Hz = number_or(table, kSwayFrequency, motion.pose_sway_Hz);
  motion.session_interval_h = number_or(table, kInterval, motion.session_interval_h);
  return motion;
}

void read_sessions(const TomlTable& table, RecordingPlan& plan) {
  plan.design = static_cast<RecordingPlan::Design>(word(table, "design", kDesigns));
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

RecordingPlan recordings_in(const TomlTable& table) {
  constexpr double kRoom_C = 20;
  table.refuse_unknown_keys(kNumbers, kOthers);
  RecordingPlan plan;
  read_sessions(table, plan);
  plan.bend_angles_deg = numbers(table, kBendAngles);
  plan.output_means_N = numbers(table, kMeans);
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

}  // namespace host_sim::synth
