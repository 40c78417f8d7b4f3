#include "host_sim/diagnose/sessions.hpp"

#include <utility>

namespace host_sim::diagnose {

RecordedSessions recorded_sessions(const Campaign& campaign) {
  RecordedSessions recorded;
  const auto recordings = recording::read_recordings(campaign.folder);
  recorded.faults = recording::faults_of(recordings);
  for (const recording::Recording& recording : recordings) {
    auto covariates = recording::covariates_of(recording, recorded.faults, campaign.nominal);
    if (covariates.samples() > 0) {
      recorded.sessions.push_back({recording.session, std::move(covariates)});
    }
  }
  return recorded;
}

}  // namespace host_sim::diagnose
