#pragma once

#include <string>

#include "host_sim/diagnose/audit.hpp"
#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose {

/// The verdict on the recordings in a few sentences.
std::string verdict_prose(const Findings& findings, std::size_t sessions);

/// What distinguishes the causes that are still in question; empty where none are.
std::string next_experiment(const Findings& findings, const Audit& audit);

}  // namespace host_sim::diagnose
