#include <fmt/format.h>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose {

using hal::files::in_quotes;
using hal::files::InputError;

namespace {

bool has_recordings(const Campaign& campaign) {
  return is_there(campaign.folder / "sessions.csv");
}

/// Effects are told apart by lives; what is known of the others here would say more than it does.
void refuse_unknown_lives(const Campaign& campaign) {
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (specimen.trimmed() || specimen.found_broken()) {
      throw InputError(
          (campaign.folder / "specimens.csv").string(), specimen.line, 0,
          fmt::format("specimen {} was {}", in_quotes(specimen.name),
                      specimen.trimmed() ? "trimmed" : "found broken at an inspection"),
          "failed and suspended specimens for diagnose; calibrate takes the others");
    }
  }
}

}  // namespace

Diagnosis diagnose(const Campaign& campaign, const DiagnoseOptions& options) {
  refuse_unknown_lives(campaign);
  Diagnosis diagnosis;
  if (has_recordings(campaign)) {
    diagnosis.tension = diagnose_tension(campaign, options);
    diagnosis.warnings = diagnosis.tension->faults;
  }
  if (!campaign.specimens.empty()) {
    diagnosis.lives = diagnose_lives(campaign, options);
  }
  return diagnosis;
}

}  // namespace host_sim::diagnose
