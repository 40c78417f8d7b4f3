#pragma once

#include <filesystem>
#include <string>

#include "host_sim/synth/plan/plan.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// What is hidden in a campaign, sealed: whoever has the digest can tell later that the text was
/// not changed.
struct Sealed {
  std::string text;    ///< JSON
  std::string sha256;  ///< 64 hexadecimal digits
};

/// The plan as the laboratory writes it into campaign.toml: with nominal values of what every
/// analysis refits.
host_sim::synth::SynthPlan nominal_plan(const Scenario& scenario);

/// Simulates the campaign of a scenario in a new folder, by one thread. Nothing in the folder says
/// what is hidden.
/// @throws OutputError, InputError, Interruption
Sealed make_blind_campaign(const Scenario& scenario, const std::filesystem::path& folder);

/// The text of the truth; `made` is JSON of what the simulation drew, empty for none.
std::string truth_text(const Scenario& scenario, const std::string& made);

/// The scenario that a truth describes, without its plan. @throws nlohmann::json::exception
Scenario scenario_of(const std::string& truth);

}  // namespace blind
