#include "host_sim/recording/usable.hpp"

#include <algorithm>

namespace host_sim::recording {
namespace {

void mark(std::vector<bool>& samples, const Fault& fault) {
  const std::size_t end = std::min(fault.first + fault.count, samples.size());
  for (std::size_t i = std::min(fault.first, end); i < end; ++i) {
    samples[i] = true;
  }
}

std::vector<Stretch> cut_at(const std::vector<Stretch>& stretches,
                            const std::vector<bool>& begins_anew) {
  std::vector<Stretch> pieces;
  for (const Stretch& stretch : stretches) {
    for (std::size_t i = stretch.first; i < stretch.end(); ++i) {
      if (i == stretch.first || begins_anew[i]) {
        pieces.push_back({i, 0});
      }
      ++pieces.back().count;
    }
  }
  return pieces;
}

}  // namespace

Usable usable_part(const Recording& recording, const std::vector<Fault>& faults) {
  const std::size_t samples = recording.samples();
  Usable usable{recording.channels, std::vector<bool>(samples), {}};
  std::vector<bool> no_velocity(samples);
  std::vector<bool> after_gap(samples);
  for (const Fault& fault : faults) {
    if (fault.session != recording.session) {
      continue;
    }
    if (fault.kind == Fault::Kind::constant) {
      usable.channels[fault.channel].clear();
      continue;
    }
    mark(usable.touched, fault);
    if (fault.kind == Fault::Kind::gap && fault.first < samples) {
      after_gap[fault.first] = true;
    } else if (fault.channel == kTendonVelocity) {
      mark(no_velocity, fault);
    }
  }
  if (!usable.channels[kTendonVelocity].empty()) {
    usable.motion = cut_at(stretches_of(no_velocity, false), after_gap);
  }
  return usable;
}

}  // namespace host_sim::recording
