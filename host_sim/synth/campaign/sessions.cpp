#include "host_sim/synth/campaign/sessions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <numbers>
#include <system_error>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/plan/plan.hpp"
#include "host_sim/synth/tension/departures.hpp"
#include "host_sim/synth/two_sided/kinds.hpp"

namespace host_sim::synth {

using hal::files::InputError;
using hal::files::kProfileColumnCount;
using hal::files::kTime;
using hal::files::OutputError;
using hal::files::profile_columns;
using hal::files::ProfileColumn;
using hal::files::ProfileColumnId;
using hal::files::write_file;

namespace {

std::unique_ptr<TensionPart> tension_part(const Departure& departure) {
  const auto kinds = departure.outside ? outside_tension_kinds() : tension_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const TensionKind& candidate) {
    return candidate.id == departure.id;
  });
  return kind->make(departure.values);
}

/// What a plan hides in its recordings, made and begun for one session; with `only`, the part of
/// that name alone.
std::vector<std::unique_ptr<TensionPart>> tension_parts(const SynthPlan& plan,
                                                        const Setting& setting, std::uint64_t seed,
                                                        std::string_view only = {}) {
  std::vector<std::unique_ptr<TensionPart>> parts;
  for (const Departure& departure : plan.departures) {
    if (!departure.of_life && (only.empty() || only == departure.id)) {
      parts.push_back(tension_part(departure));
      parts.back()->begin(setting, seed);
    }
  }
  return parts;
}

TwoSidedEffects two_sided_effects(const SynthPlan& plan) {
  TwoSidedEffects effects;
  for (const Departure& departure : plan.departures) {
    const auto kinds = departure.outside ? outside_two_sided_kinds() : two_sided_kinds();
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const TwoSidedKind& candidate) {
      return !departure.of_life && candidate.id == departure.id;
    });
    if (kind != kinds.end()) {
      kind->add(departure.values, effects);
    }
  }
  return effects;
}

namespace fs = std::filesystem;

std::string session_name(std::size_t number, std::size_t count) {
  return fmt::format("s{:0{}}", number + 1,
                     std::max<std::size_t>(3, fmt::formatted_size("{}", count)));
}

/// @param specimen that all were recorded of
std::string sessions_text(const std::vector<Setting>& settings, const std::string& specimen) {
  std::string text = "session,specimen,file,start_cycle\n";
  for (const Setting& setting : settings) {
    const std::string name = session_name(setting.number, settings.size());
    fmt::format_to(std::back_inserter(text), "{0},{2},recordings/{0}.csv,{1:.17g}\n", name,
                   setting.start_cycle, specimen);
  }
  return text;
}

double bend_error_deg(const SynthPlan& plan, const Setting& setting, std::uint64_t seed) {
  double angle_rad = 0;
  for (const auto& part : tension_parts(plan, setting, seed, "bend_angle")) {
    angle_rad = part->bend_angle_rad(angle_rad, {});
  }
  return angle_rad * 180 / std::numbers::pi;
}

void check_ranges(const SynthPlan& plan, const Setting& setting, const Channels& channels) {
  for (unsigned id = 0; id < kProfileColumnCount; ++id) {
    const ProfileColumn& column = profile_columns()[id];
    for (const double value : channels[id]) {
      if (!(value >= column.minimum && value <= column.maximum)) {
        throw InputError(
            plan.file, 0, 0,
            fmt::format("in session {}, {} gets to {}", setting.number + 1, column.name, value),
            fmt::format("a plan whose readings stay in {}..{} {}", column.minimum, column.maximum,
                        column.unit));
      }
    }
  }
}

Rig rig_of(const SynthPlan& plan) {
  const RecordingPlan& recordings = *plan.recordings;
  Rig rig;
  rig.friction_coefficient = plan.model.sheath->friction_coefficient;
  if (plan.model.drive) {
    rig.drive.emplace(*plan.model.drive);
  }
  rig.motion = recordings.motion;
  rig.thermal = plan.thermal;
  rig.sample_rate_Hz = recordings.sample_rate_Hz;
  rig.duration_s = recordings.duration_s;
  return rig;
}

}  // namespace

SessionScatter session_scatter(const SynthPlan& plan, std::uint64_t seed, std::size_t session) {
  Random random(seed, kSessionStream, session);
  const double log_gain = plan.scatter.log_gain_sd * normal(random);
  const double friction = plan.scatter.friction_sd * normal(random);
  return {log_gain, std::max(friction, -plan.model.sheath->friction_coefficient)};
}

Channels session_channels(const SynthPlan& plan, const Setting& setting,
                          const SessionScatter& scatter, std::uint64_t seed) {
  const Rig rig = rig_of(plan);
  const Instants instants =
      draw_instants(plan.noise, seed, setting.number, samples_of(rig), rig.sample_rate_Hz);
  Channels channels =
      plan.two_sided
          ? simulate_two_sided(rig, setting, scatter, two_sided_effects(plan), instants)
          : simulate(rig, setting, scatter, tension_parts(plan, setting, seed), instants);
  add_noise(plan.noise, seed, setting.number, channels);
  check_ranges(plan, setting, channels);
  return channels;
}

std::string recording_text(const std::vector<ProfileColumnId>& wanted, const Channels& channels) {
  std::vector<ProfileColumnId> columns;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(columns),
               [&](ProfileColumnId id) { return !channels[id].empty(); });
  fmt::memory_buffer text;
  for (std::size_t row = 0; row <= channels[kTime].size(); ++row) {
    for (const ProfileColumnId id : columns) {
      if (row == 0) {
        fmt::format_to(std::back_inserter(text), "{},", profile_columns()[id].name);
      } else {
        fmt::format_to(std::back_inserter(text), "{:.10g},", channels[id][row - 1]);
      }
    }
    text.data()[text.size() - 1] = '\n';
  }
  return fmt::to_string(text);
}

Truth write_sessions(const SynthPlan& plan, const MakeOptions& options, const fs::path& folder) {
  Truth truth;
  truth.settings = settings_of(*plan.recordings, options.seed);
  for (const Setting& setting : truth.settings) {
    truth.scatter.push_back(session_scatter(plan, options.seed, setting.number));
    truth.bend_errors_deg.push_back(bend_error_deg(plan, setting, options.seed));
  }
  const std::size_t count = truth.settings.size();
  std::error_code error;
  if (!fs::create_directory(folder / "recordings", error) || error) {
    throw OutputError((folder / "recordings").string(), error.message());
  }
  write_file(folder / "sessions.csv",
             sessions_text(truth.settings, plan.lives ? specimen_name(0) : "tendon"));
  std::atomic<std::size_t> done = 0;
  statistics::parallel_for(
      count,
      [&](std::size_t i) {
        const Channels channels =
            session_channels(plan, truth.settings[i], truth.scatter[i], options.seed);
        write_file(folder / "recordings" / fmt::format("{}.csv", session_name(i, count)),
                   recording_text(plan.recordings->channels, channels));
        if (options.progress) {
          options.progress(static_cast<double>(++done) / static_cast<double>(count));
        }
      },
      options.threads);
  return truth;
}

}  // namespace host_sim::synth
