#include "host_sim/diagnose/sessions.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "host_sim/recording/channel_noise.hpp"
#include "host_sim/reference/reference.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kSamePose_rad = 0.0174532925199432958;  // a degree

double mean_of(const std::vector<double>& values) {
  return values.empty() ? 0
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

}  // namespace

RecordedSessions recorded_sessions(const Campaign& campaign) {
  RecordedSessions recorded;
  recorded.recordings = recording::read_recordings(campaign.folder, campaign.columns);
  recorded.faults = recording::faults_of(recorded.recordings, campaign.two_sided);
  if (campaign.two_sided) {
    return recorded;
  }
  for (const recording::Recording& recording : recorded.recordings) {
    auto covariates = recording::covariates_of(recording, recorded.faults, campaign.nominal);
    if (covariates.samples() > 0) {
      recording::add_noise(covariates);
      recorded.sessions.push_back({recording.session, std::move(covariates)});
    }
  }
  return recorded;
}

std::vector<double> poses_of(std::span<const Session> sessions) {
  std::vector<double> means;
  for (const Session& session : sessions) {
    if (session.covariates.samples() > 0) {
      means.push_back(mean_of(session.covariates.bend_angle_rad));
    }
  }
  std::ranges::sort(means);
  std::vector<double> poses;
  double last_rad = 0;
  for (const double mean_rad : means) {
    if (poses.empty() || mean_rad - last_rad > kSamePose_rad) {
      poses.push_back(mean_rad);
    }
    last_rad = mean_rad;
  }
  return poses;
}

double damage_of(std::span<const double> tension_N, const reference::Constants& constants) {
  reference::Reference count(constants);
  for (const double value_N : tension_N) {
    count.push(value_N);
  }
  return count.reading().damage.total;
}

}  // namespace host_sim::diagnose
