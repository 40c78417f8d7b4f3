#include "host_sim/diagnose/plan/foresee.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/plan/scratch_folder.hpp"
#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/io/input_error.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace host_sim::diagnose {
namespace {

/// No campaign is better than this: calibration and rounding remain.
constexpr double kLeastSample_sd = 1e-3;
constexpr double kLeastGain_sd = 1e-3;
constexpr double kLeastFriction_sd = 1e-3;

NoiseModel noise_of(const synth::SynthPlan& plan) {
  // Both tensions of the ratio have noise of their own; whitening leaves the innovations.
  const double ratio_sd = std::sqrt(2.0) * plan.noise.log_tension_sd;
  const double whitened = std::sqrt(1 - plan.noise.ar1 * plan.noise.ar1);
  NoiseModel noise;
  noise.sample_sd = std::max(ratio_sd, kLeastSample_sd) * whitened;
  noise.session_gain_sd = std::max(plan.scatter.log_gain_sd, kLeastGain_sd);
  noise.session_friction_sd = std::max(plan.scatter.friction_sd, kLeastFriction_sd);
  return noise;
}

std::vector<Session> simulated_sessions(synth::SynthPlan plan, const ForeseeOptions& options) {
  plan.hidden.clear();
  plan.lives.reset();
  plan.noise = {};
  plan.scatter = {};
  const ScratchFolder scratch;
  synth::make_campaign(plan, {options.seed, options.threads, options.progress}, scratch.path());
  return recorded_sessions(read_campaign(scratch.path())).sessions;
}

}  // namespace

Foresight foresee(const synth::SynthPlan& plan, const ForeseeOptions& options) {
  if (!plan.recordings) {
    throw InputError(plan.file, 0, 0, "no table [recordings]", "a plan of recordings");
  }
  const std::vector<Session> sessions = simulated_sessions(plan, options);
  if (sessions.empty()) {
    throw InputError(plan.file, 0, 0, "no session leaves a sample: nothing moves, or too little",
                     "travels_mm of at least 5");
  }
  Foresight foresight;
  foresight.noise = noise_of(plan);
  foresight.sessions = sessions.size();
  for (const Session& session : sessions) {
    foresight.samples += session.covariates.samples();
  }
  GramOptions gram;
  gram.baseline.friction_coefficient = plan.sheath->friction_coefficient;
  gram.autocorrelation = plan.noise.ar1;
  gram.threads = options.threads;
  foresight.audit = audit(gram_of(sessions, gram), foresight.noise);
  return foresight;
}

}  // namespace host_sim::diagnose
