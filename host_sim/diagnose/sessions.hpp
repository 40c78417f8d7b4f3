#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/recording/covariates.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

/// Below this many sessions their scatter is not known, and no effect is named.
inline constexpr std::size_t kLeastSessions = 4;

/// One session: the unit of every fit.
struct Session {
  std::string name;
  recording::Covariates covariates;
};

/// The recordings of a campaign, and the sessions that left samples once faults are taken out, in
/// order of their names; none of forces that work in both directions, which have no logarithm.
struct RecordedSessions {
  std::vector<recording::Recording> recordings;
  std::vector<Session> sessions;
  std::vector<recording::Fault> faults;
};

/// @throws InputError as read_recordings() and covariates_of() do
RecordedSessions recorded_sessions(const Campaign& campaign);

/// The poses of a campaign: the mean bend angles of its sessions, rising, those within a degree of
/// the one before counted as one.
std::vector<double> poses_of(std::span<const Session> sessions);

/// Damage of a tension over time, counted whole.
double damage_of(std::span<const double> tension_N, const reference::Constants& constants);

}  // namespace host_sim::diagnose
