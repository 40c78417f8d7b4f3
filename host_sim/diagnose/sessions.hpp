#pragma once

#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/gram.hpp"

namespace host_sim::diagnose {

/// The sessions of a campaign that left samples once its faults are taken out, in order of their
/// names.
struct RecordedSessions {
  std::vector<Session> sessions;
  std::vector<recording::Fault> faults;
};

/// @throws InputError as read_recordings() and covariates_of() do
RecordedSessions recorded_sessions(const Campaign& campaign);

}  // namespace host_sim::diagnose
