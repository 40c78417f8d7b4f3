#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/diagnose_recorded.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::diagnose {
namespace {

bool has_recordings(const Campaign& campaign) {
  return is_there(campaign.folder / "sessions.csv");
}

}  // namespace

Diagnosis diagnose(const Campaign& campaign, const DiagnoseOptions& options) {
  Diagnosis diagnosis;
  if (has_recordings(campaign)) {
    const RecordedSessions recorded = recorded_sessions(campaign);
    for (const recording::FaultSummary& summary : recording::summary_of(recorded.faults)) {
      diagnosis.warnings.push_back(summary.words);
    }
    diagnosis.tension = diagnose_recorded(campaign, recorded, options);
  }
  if (!campaign.specimens.empty()) {
    diagnosis.lives = diagnose_lives(campaign, options);
  }
  return diagnosis;
}

}  // namespace host_sim::diagnose
