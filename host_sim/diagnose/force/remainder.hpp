#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_covariates.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// The name of what sessions differ in that no covariate holds.
inline constexpr std::string_view kSession = "session";

/// The same of what goes on from each session to the next.
inline constexpr std::string_view kOfSessions = "order of sessions";

/// The same of what goes on in each session, other than in the others.
inline constexpr std::string_view kOfTime = "time";

/// What a model leaves that is the same in all sessions, or goes with what they differ in.
struct ForceRemainder {
  std::string_view covariate;  ///< that it depends on most
  double p = 1;                ///< that chance alone shows as much against any of them
  double share = 0;  ///< of the squared residuals beside the scatter of gain and friction, of what
                     ///< repeats
  bool stands = false;  ///< chance does not show it, and noise does not leave as much
  std::vector<Discrepancy> discrepancies;  ///< of each covariate
  std::vector<RemainderPicture> pictures;  ///< against that covariate first, before and after
};

/// What repeats is compared with signs of sessions that are turned over at random; gain and
/// friction that suit each session, against a parabola of a covariate of sessions, with sessions
/// that change places. The p of each is that of the rarest of all. What goes on in time is
/// compared with its scatter between sessions.
ForceRemainder remainder_of(const ForceData& data, const ForceFit& nominal, const ForceFit& model,
                            const std::vector<ForceCovariate>& covariates,
                            const std::vector<CovariateBins>& bins, std::uint64_t seed);

}  // namespace host_sim::diagnose
