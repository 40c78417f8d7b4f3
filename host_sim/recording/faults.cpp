#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "hal/files/text.hpp"
#include "host_sim/recording/fault_rules.hpp"
#include "host_sim/recording/motion.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

using hal::files::in_quotes;
using hal::files::NearlyColumn;
using enum hal::files::ProfileColumnId;
using hal::files::profile_columns;
using hal::files::ProfileColumnId;

namespace {

constexpr std::string_view kSamplesOut = "these samples are left out";

std::string_view name_of(ProfileColumnId channel) {
  return profile_columns()[channel].name;
}

std::string value_text(ProfileColumnId channel, double value) {
  return channel == kTendonVelocity
             ? fmt::format("{:g} m/s", value)
             : fmt::format("{:g} {}", value, profile_columns()[channel].unit);
}

std::string session_text(const Recording& recording) {
  return fmt::format("session {}", in_quotes(recording.session));
}

std::string time_text(const Recording& recording, const Stretch& stretch) {
  const std::vector<double>& time_s = recording[kTime];
  return fmt::format("from {:g} s to {:g} s", time_s[stretch.first], time_s[stretch.end() - 1]);
}

/// Where a fault is, what it is and what is done about it, in a sentence.
std::string gap_prose(const Recording& recording, const Stretch& gap) {
  const std::vector<double>& time_s = recording[kTime];
  return fmt::format(
      "{}: no samples from {:g} s to {:g} s; direction and travel are taken up anew behind the gap",
      session_text(recording), time_s[gap.first - 1], time_s[gap.first]);
}

std::string constant_prose(const Recording& recording, ProfileColumnId channel) {
  const std::string value = value_text(channel, recording[channel].front());
  return fmt::format("{}: {} is {} in all samples; the channel is left out as if not recorded",
                     session_text(recording), name_of(channel), value);
}

std::string dead_load_prose(const Recording& recording) {
  return fmt::format(
      "{}: {} is {} in all samples, and no session changes it; it is taken for a dead load, which "
      "a load cell that does not work would look like",
      session_text(recording), name_of(kOutputTensionColumn),
      value_text(kOutputTensionColumn, recording[kOutputTensionColumn].front()));
}

std::string stuck_prose(const Recording& recording, const LiveChannel& channel,
                        const Stretch& stretch) {
  const bool noisy = channel.sensor.longest_by_chance != 0;
  return fmt::format(
      "{}: {} is stuck at {} {}, {}; {}", session_text(recording), name_of(channel.id),
      value_text(channel.id, channel.values[stretch.first]), time_text(recording, stretch),
      noisy ? "without the noise that it has elsewhere" : "while other channels show motion",
      kSamplesOut);
}

std::string saturated_prose(const Recording& recording, const LiveChannel& channel,
                            const Stretch& stretch) {
  const double value = channel.values[stretch.first];
  return fmt::format("{}: {} stays at {}, its {} value, {}: saturated; {}", session_text(recording),
                     name_of(channel.id), value_text(channel.id, value),
                     value == channel.sensor.highest ? "largest" : "smallest",
                     time_text(recording, stretch), kSamplesOut);
}

using Words = std::string (*)(const Recording&, const LiveChannel&, const Stretch&);

/// Collects the faults of one session.
class Session {
 public:
  Session(const Recording& recording, bool dead_load)
      : recording_(recording), dead_load_(dead_load) {
    for (unsigned id = kInputTensionColumn; id < kProfileColumnCount; ++id) {
      const auto channel = static_cast<ProfileColumnId>(id);
      if (recording.has(channel)) {
        channels_.push_back({channel, recording[channel], sensor_of(recording[channel])});
      }
    }
  }

  std::vector<Fault> faults() {
    const std::vector<Stretch> gaps = gaps_in(recording_[kTime]);
    find_slips(gaps);
    for (const NearlyColumn& column : recording_.nearly) {
      add(column.id, Fault::Kind::passed_over, {0, 0},
          fmt::format("{}: {}", session_text(recording_), column.words));
    }
    for (const Stretch& gap : gaps) {
      add(kTime, Fault::Kind::gap, gap, gap_prose(recording_, gap));
    }
    for (const LiveChannel& channel : channels_) {
      if (channel.id == kOutputTensionColumn && dead_load_) {
        add(channel.id, Fault::Kind::dead_load, {0, recording_.samples()},
            dead_load_prose(recording_));
      } else if (has_to_change(channel.id) && channel.sensor.span() == 0) {
        add(channel.id, Fault::Kind::constant, {0, recording_.samples()},
            constant_prose(recording_, channel.id));
      } else if (has_to_change(channel.id)) {
        add_faults_of(channel);
      }
    }
    return std::move(faults_);
  }

 private:
  void find_slips(const std::vector<Stretch>& gaps) {
    const std::vector<double>& velocity_m_s = recording_[kTendonVelocity];
    if (velocity_m_s.empty() || sensor_of(velocity_m_s).span() == 0) {
      return;
    }
    std::vector<Stretch> pieces{{0, recording_.samples()}};
    for (const Stretch& gap : gaps) {
      pieces.back().count = gap.first - pieces.back().first;
      pieces.push_back({gap.first, recording_.samples() - gap.first});
    }
    slips_ =
        slips_of(motion_of(recording_[kTime], velocity_m_s, pieces, dead_band_m_s(velocity_m_s)));
  }

  void add(ProfileColumnId channel, Fault::Kind kind, const Stretch& stretch, std::string words) {
    faults_.push_back(
        {recording_.session, channel, kind, stretch.first, stretch.count, std::move(words)});
  }

  void add_all(const LiveChannel& channel, Fault::Kind kind, const std::vector<Stretch>& stretches,
               Words words) {
    for (const Stretch& stretch : stretches) {
      add(channel.id, kind, stretch, words(recording_, channel, stretch));
    }
  }

  void add_faults_of(const LiveChannel& channel) {
    const SessionView session{recording_[kTime], channels_, slips_};
    add_all(channel, Fault::Kind::stuck, stuck_in(channel, session), stuck_prose);
    add_all(channel, Fault::Kind::saturated, saturated_in(channel, session), saturated_prose);
  }

  const Recording& recording_;
  bool dead_load_;
  std::vector<LiveChannel> channels_;
  std::vector<Stretch> slips_;
  std::vector<Fault> faults_;
};

/// Whether the output tension is a number that was written beside what was measured.
bool is_dead_load(const std::vector<Recording>& recordings) {
  const auto input_goes = [&](double way) {
    return std::ranges::any_of(recordings, [&](const Recording& recording) {
      const auto goes = [&](double value) { return way * value > 0; };
      return std::ranges::any_of(recording[kInputTensionColumn], goes) ||
             std::ranges::any_of(recording[kMotorCurrentColumn], goes);
    });
  };
  const bool both_ways = input_goes(1) && input_goes(-1);
  return std::ranges::all_of(recordings, [&](const Recording& recording) {
    const std::vector<double>& output_N = recording[kOutputTensionColumn];
    return !output_N.empty() && (output_N.front() != 0 || both_ways) &&
           std::ranges::all_of(output_N, [&](double value_N) { return value_N == output_N[0]; });
  });
}

}  // namespace

std::vector<Fault> faults_of(const std::vector<Recording>& recordings) {
  const bool dead_load = is_dead_load(recordings);
  std::vector<Fault> faults;
  for (const Recording& recording : recordings) {
    for (Fault& fault : Session(recording, dead_load).faults()) {
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

std::vector<FaultSummary> summary_of(const std::vector<Fault>& faults) {
  std::map<std::pair<ProfileColumnId, Fault::Kind>, FaultSummary> summaries;
  std::map<std::pair<ProfileColumnId, Fault::Kind>, std::set<std::string>> sessions;
  for (const Fault& fault : faults) {
    const auto key = std::pair(fault.channel, fault.kind);
    FaultSummary& summary = summaries[key];
    if (summary.faults == 0) {
      summary.channel = fault.channel;
      summary.kind = fault.kind;
      summary.words = fault.words;
    }
    sessions[key].insert(fault.session);
    ++summary.faults;
    summary.samples += fault.count;
  }
  std::vector<FaultSummary> all;
  for (auto& [key, summary] : summaries) {
    summary.sessions = sessions[key].size();
    if (summary.faults > 1) {
      summary.words +=
          fmt::format("; {} times like this, in {} session{} and {} samples", summary.faults,
                      summary.sessions, summary.sessions == 1 ? "" : "s", summary.samples);
    }
    all.push_back(std::move(summary));
  }
  return all;
}

}  // namespace host_sim::recording
