#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "host_sim/synth/campaign/truth.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::synth {

struct MakeOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0 is one for each core; the files do not depend on it
  std::function<void(double share)> progress = {};
};

/// Writes the files of a campaign into an existing folder that is empty.
/// @throws OutputError, Interruption
Truth make_campaign(const SynthPlan& plan, const MakeOptions& options,
                    const std::filesystem::path& folder);

}  // namespace host_sim::synth
