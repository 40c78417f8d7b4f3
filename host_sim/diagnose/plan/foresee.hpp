#pragma once

#include <cstdint>
#include <functional>

#include "host_sim/diagnose/audit.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::diagnose {

/// What a planned campaign could show and tell apart.
struct Foresight {
  NoiseModel noise;  ///< of the plan
  std::size_t sessions = 0;
  std::size_t samples = 0;
  Audit audit;
};

struct ForeseeOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores; the result does not depend on it
  std::function<void(double share)> progress = {};
};

/// Simulates the campaign with nothing hidden in it, and audits its design.
/// @throws InputError where the plan has no recordings, or none that leaves samples
Foresight foresee(const synth::SynthPlan& plan, const ForeseeOptions& options);

}  // namespace host_sim::diagnose
