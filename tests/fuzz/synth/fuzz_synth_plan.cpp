// Whatever the bytes: a plan that can be simulated, or an InputError. What is made of it is small.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/campaign/sessions.hpp"
#include "host_sim/synth/plan/plan.hpp"
#include "tests/fuzz/io/require.hpp"

using namespace host_sim::synth;
using host_sim::fuzz::require;

namespace {

void check_recordings(SynthPlan plan) {
  RecordingPlan& recordings = *plan.recordings;
  const std::size_t sessions = session_count(recordings);
  require(sessions >= 1 && sessions <= kMostSessions);
  recordings.sample_rate_Hz = 4000;
  recordings.duration_s = 10 / recordings.sample_rate_Hz;
  const Setting setting = settings_of(recordings, 1).back();
  const SessionScatter scatter = session_scatter(plan, 1, setting.number);
  const Channels channels = session_channels(plan, setting, scatter, 1);
  require(channels[hal::files::kTime].size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    require(std::isfinite(channels[hal::files::kTime][i]));
    require(i == 0 || channels[hal::files::kTime][i] > channels[hal::files::kTime][i - 1]);
    require(!std::isnan(channels[hal::files::kInputTensionColumn][i]));
    require(std::isfinite(channels[hal::files::kOutputTensionColumn][i]));
    require(plan.two_sided || channels[hal::files::kOutputTensionColumn][i] > -1e4);
  }
}

void check_lives(const SynthPlan& plan) {
  if (plan.lives->specimens() > 100) {
    return;
  }
  for (const LifeSpecimen& specimen : run_lives(plan, 1)) {
    require(!specimen.result.cycles.empty());
    for (const double cycles : specimen.result.cycles) {
      require(cycles >= 1 && cycles <= 1e15 && cycles == std::round(cycles));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const SynthPlan plan = parse_synth_plan(text, "fuzz");
    require(plan.recordings || plan.lives);
    if (plan.recordings) {
      check_recordings(plan);
    }
    if (plan.lives) {
      check_lives(plan);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
