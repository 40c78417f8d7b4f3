#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>

#include "host_sim/diagnose/audit/audit.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace host_sim::diagnose {

/// A new folder for files of this run, gone with all of them at the end.
class ScratchFolder {
 public:
  /// @throws OutputError
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// What a planned campaign could show and distinguish.
struct Foresight {
  NoiseModel noise;  ///< of the plan
  std::size_t sessions = 0;
  std::size_t samples = 0;
  Audit audit;
};

/// Noise of the input force beside what the nominal model makes of the output force, which passes
/// on the noise of that one as it passes on the force. Of noise that goes on it is what each sample
/// has that is new, in N.
/// @param records that the plan makes, with nothing hidden in them
NoiseModel noise_of(const synth::SynthPlan& plan, std::span<const effects::ForceRecord> records);

struct ForeseeOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores; the result does not depend on it
  std::function<void(double share)> progress = {};
};

/// Simulates the campaign with nothing hidden in it, and audits its design.
/// @throws InputError where the plan has no recordings, or none that leaves samples
Foresight foresee(const synth::SynthPlan& plan, const ForeseeOptions& options);

/// {"sessions", "samples", "effects": [{"id", "visible", "share_left", "standard_deviations",
/// "words"}], "equivalent_sets": [[id, ...]], "invisible": [id], "next_experiment"}
std::string foresight_json(const Foresight& foresight);

/// The same for people: a line for each effect, the clearest first.
void write_foresight(std::ostream& out, const Foresight& foresight);

}  // namespace host_sim::diagnose
