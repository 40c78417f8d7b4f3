#include <algorithm>
#include <utility>

#include "host_sim/recording/fault_rules.hpp"
#include "host_sim/recording/fault_words.hpp"
#include "host_sim/recording/motion.hpp"

namespace host_sim::recording {
namespace {

using Words = std::string (*)(const Recording&, const LiveChannel&, const Stretch&);

/// Collects the faults of one session.
class Session {
 public:
  explicit Session(const Recording& recording) : recording_(recording) {
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
    for (const Stretch& gap : gaps) {
      add(kTime, Fault::Kind::gap, gap, gap_words(recording_, gap));
    }
    for (const LiveChannel& channel : channels_) {
      if (has_to_change(channel.id) && channel.sensor.span() == 0) {
        add(channel.id, Fault::Kind::constant, {0, recording_.samples()},
            constant_words(recording_, channel.id));
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
    add_all(channel, Fault::Kind::stuck, stuck_in(channel, session), stuck_words);
    add_all(channel, Fault::Kind::saturated, saturated_in(channel, session), saturated_words);
    if (is_load(channel.id)) {
      add_all(channel, Fault::Kind::not_positive, not_positive_in(channel), not_positive_words);
    }
  }

  const Recording& recording_;
  std::vector<LiveChannel> channels_;
  std::vector<Stretch> slips_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> faults_of(const std::vector<Recording>& recordings) {
  std::vector<Fault> faults;
  for (const Recording& recording : recordings) {
    for (Fault& fault : Session(recording).faults()) {
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

}  // namespace host_sim::recording
