#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/synth/plan/plan.hpp"
#include "host_sim/synth/tension/rig.hpp"

namespace host_sim::synth {

/// What was hidden in a campaign and drawn for it.
struct Truth {
  std::vector<Setting> settings;
  std::vector<SessionScatter> scatter;  ///< for each setting
  std::vector<double> bend_errors_deg;  ///< for each setting, of the effect bend_angle
};

/// The truth as JSON.
std::string truth_json(const SynthPlan& plan, std::uint64_t seed, const Truth& truth);

/// SHA-256 of a text, as 64 hexadecimal digits.
std::string sha256(std::string_view text);

struct MakeOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0 is one for each core; the files do not depend on it
  std::function<void(double share)> progress = {};
};

/// Writes the files of a campaign into an existing folder that is empty.
/// @throws OutputError, Interruption
Truth make_campaign(const SynthPlan& plan, const MakeOptions& options,
                    const std::filesystem::path& folder);

/// campaign.toml: the name and the nominal model, nothing of what is hidden.
std::string campaign_text(const SynthPlan& plan);

}  // namespace host_sim::synth
