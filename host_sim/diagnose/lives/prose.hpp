#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/discrepancy.hpp"
#include "host_sim/diagnose/lives/hypotheses.hpp"

namespace host_sim::diagnose::lives {

/// The experiment that distinguishes the candidates of a set, as the catalogue has it from either
/// side; for one effect against another that the set does not hold, its first; empty for none.
std::string experiment_for(const std::vector<std::string>& credible_set);

/// The verdict in sentences. `after` has no tests where nothing was extended.
std::string verdict_prose(const Findings& findings, const Omnibus& before, const Omnibus& after);

/// How much better the lives fit the laws of mean stress that a hypothesis holds than Gerber's, as
/// a sentence behind others; empty where it holds none.
/// @param hypotheses with the one that lacks mean_stress alone
std::string mean_stress_prose(const std::vector<Hypothesis>& hypotheses, const Hypothesis& best);

struct ShapeTestOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// A sentence on the level whose Weibull shape is least like that of the others, by the likelihood
/// ratio of (17) and (18) for one level against the rest; empty where none differs at 5 % for all
/// levels that were tested.
std::string shape_prose(const Campaign& campaign, const ShapeTestOptions& options);

}  // namespace host_sim::diagnose::lives
