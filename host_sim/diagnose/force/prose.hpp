#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

/// The verdict in a few sentences: causes with what they take off, or how far effects go that do
/// not explain all, and what is left.
/// @param findings with effects, steps, equivalent sets and the remainder
/// @param nominal_rmse_N of the input force on sessions that the fit never saw
/// @param spoilt whether a doubt keeps anything from being named
std::string verdict_prose(const Findings& findings, std::size_t sessions, double nominal_rmse_N,
                          bool spoilt);

/// "wear of the sheath (friction_wear, 99.6 %) and ..."
std::string listed(const std::vector<FoundEffect>& effects);

/// What effects take off that do not explain all, behind other sentences; empty where none takes
/// any off.
std::string how_far(const std::vector<Step>& steps);

/// Why an effect is not named that explains what is there, behind other sentences.
std::string imitation_prose(const effects::ForceLaw& effect, const effects::ForceLaw& outside);

/// What is likely beside the causes, but not named, behind other sentences.
std::string doubtful_prose(const effects::ForceLaw& effect, double probability);

/// Which of causes that could be each other's a model holds that is written, behind other
/// sentences.
std::string either_way_prose(const effects::ForceTerms& written);

/// What of the causes no controller evaluates, behind other sentences.
/// @param rmse_N of the input force by a model that is written
std::string not_written_prose(const std::vector<std::string>& terms, bool corrected, double rmse_N);

/// "A correction ... takes the error ... from ... to ..." behind other sentences.
std::string correction_prose(const Correction& correction);

}  // namespace host_sim::diagnose
