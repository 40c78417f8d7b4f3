#pragma once

#include <span>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/recording/covariates.hpp"

namespace host_sim::diagnose {

/// One session: the unit of every fit.
struct Session {
  std::string name;
  recording::Covariates covariates;
};

/// The sessions of a campaign that left samples once its faults are taken out, in order of their
/// names.
struct RecordedSessions {
  std::vector<Session> sessions;
  std::vector<recording::Fault> faults;
};

/// @throws InputError as read_recordings() and covariates_of() do
RecordedSessions recorded_sessions(const Campaign& campaign);

/// The poses of a campaign: the mean bend angles of its sessions, rising, those within a degree of
/// the one before counted as one.
std::vector<double> poses_of(std::span<const Session> sessions);

}  // namespace host_sim::diagnose
