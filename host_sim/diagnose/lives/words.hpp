#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/discrepancy.hpp"

namespace host_sim::diagnose::lives {

/// The experiment that tells the candidates of a set apart, as the catalogue has it from either
/// side; for one effect against another that the set does not hold, its first; empty for none.
std::string experiment_for(const std::vector<std::string>& credible_set);

/// The verdict in sentences. `after` has no looks where nothing was extended.
std::string verdict_words(const Findings& findings, const Omnibus& before, const Omnibus& after);

}  // namespace host_sim::diagnose::lives
