#include "host_sim/diagnose/plan/foresee.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <system_error>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;
using hal::files::OutputError;

namespace {

double middle_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Noise of the logarithm of a ratio of tensions.
struct RatioNoise {
  double sd = 0;
  double ar1 = 0;
};

/// Both ends of the ratio have noise of their own. What is not in proportion to a tension counts at
/// the mean one; the correlation is that of the sum from one sample to the next.
RatioNoise ratio_noise_of(const synth::SynthPlan& plan) {
  const double mean_N = middle_of(plan.recordings->output_means_N);
  const auto& channels = plan.recordings->channels;
  const bool by_current = std::find(channels.begin(), channels.end(),
                                    hal::files::kInputTensionColumn) == channels.end();
  double input_floor = plan.noise.input.absolute_N / mean_N;
  if (by_current) {
    const Model::Drive& drive = *plan.model.drive;
    input_floor = plan.noise.input.absolute_A * drive.torque_constant_Nm_per_A * drive.gear_ratio *
                  drive.gear_efficiency / (drive.spool_radius_m() * mean_N);
  }
  const double output =
      std::hypot(plan.noise.output.relative_sd, plan.noise.output.absolute_N / mean_N);
  const double input = std::hypot(plan.noise.input.relative_sd, input_floor);
  const double sd = std::hypot(output, input);
  const double covariance =
      output * output * plan.noise.output.ar1 + input * input * plan.noise.input.ar1;
  return {sd, sd > 0 ? covariance / (sd * sd) : plan.noise.output.ar1};
}

NoiseModel noise_of(const synth::SynthPlan& plan) {
  // Whitening leaves the innovations.
  const RatioNoise ratio = ratio_noise_of(plan);
  const double whitened = std::sqrt(1 - ratio.ar1 * ratio.ar1);
  NoiseModel noise;
  noise.sample_sd = std::max(ratio.sd, kLeastNoise.sample_sd) * whitened;
  noise.session_gain_sd = std::max(plan.scatter.log_gain_sd, kLeastNoise.session_gain_sd);
  noise.session_friction_sd = std::max(plan.scatter.friction_sd, kLeastNoise.session_friction_sd);
  return noise;
}

std::vector<Session> simulated_sessions(synth::SynthPlan plan, const ForeseeOptions& options) {
  plan.departures.clear();
  plan.lives.reset();
  plan.noise = {};
  plan.scatter = {};
  const ScratchFolder scratch;
  synth::make_campaign(plan, {options.seed, options.threads, options.progress}, scratch.path());
  return recorded_sessions(read_campaign(scratch.path())).sessions;
}

using nlohmann::ordered_json;

std::string experiments_of(const Audit& audit) {
  std::string text;
  for (const EquivalenceClass& same : audit.classes) {
    if (same.members.size() > 1) {
      for (const std::string& experiment : same.experiments) {
        text += text.empty() ? "" : "; ";
        text += experiment;
      }
    }
  }
  return text;
}

ordered_json sets_of(const Audit& audit) {
  ordered_json sets = ordered_json::array();
  for (const EquivalenceClass& same : audit.classes) {
    if (same.members.size() > 1) {
      ordered_json ids = ordered_json::array();
      for (const std::size_t member : same.members) {
        ids.push_back(audit.effects[member].effect->id());
      }
      sets.push_back(std::move(ids));
    }
  }
  return sets;
}

std::vector<const EffectAudit*> clearest_first(const Audit& audit) {
  std::vector<const EffectAudit*> effects;
  effects.reserve(audit.effects.size());
  for (const EffectAudit& effect : audit.effects) {
    effects.push_back(&effect);
  }
  std::stable_sort(effects.begin(), effects.end(), [](const auto* one, const auto* other) {
    return std::pair(one->visible(), one->sigmas) > std::pair(other->visible(), other->sigmas);
  });
  return effects;
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "host_sim-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw OutputError(name, std::strerror(errno));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

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
  gram.baseline.friction_coefficient = plan.model.sheath->friction_coefficient;
  gram.autocorrelation = ratio_noise_of(plan).ar1;
  gram.threads = options.threads;
  foresight.audit = audit(gram_of(sessions, gram), foresight.noise);
  return foresight;
}

std::string foresight_json(const Foresight& foresight) {
  ordered_json effects = ordered_json::array();
  ordered_json invisible = ordered_json::array();
  for (const EffectAudit& effect : foresight.audit.effects) {
    effects.push_back({{"id", effect.effect->id()},
                       {"visible", effect.visible()},
                       {"share_left", effect.share},
                       {"standard_deviations", effect.sigmas},
                       {"words", effect.prose}});
    if (!effect.visible()) {
      invisible.push_back(effect.effect->id());
    }
  }
  const ordered_json json{
      {"sessions", foresight.sessions},    {"samples", foresight.samples},
      {"effects", std::move(effects)},     {"equivalent_sets", sets_of(foresight.audit)},
      {"invisible", std::move(invisible)}, {"next_experiment", experiments_of(foresight.audit)}};
  return json.dump(2) + "\n";
}

void write_foresight(std::ostream& out, const Foresight& foresight) {
  fmt::print(out, "{} sessions, {} samples: what this campaign could show\n", foresight.sessions,
             foresight.samples);
  for (const EffectAudit* effect : clearest_first(foresight.audit)) {
    fmt::print(out, "  {:<22}{}{}\n", effect->effect->id(),
               effect->visible() ? "detectable: " : "not detectable: ", effect->prose);
  }
  bool all_apart = true;
  for (const EquivalenceClass& same : foresight.audit.classes) {
    if (same.members.size() > 1) {
      all_apart = false;
      fmt::print(out, "not distinguishable:");
      for (const std::size_t member : same.members) {
        fmt::print(out, " {}", foresight.audit.effects[member].effect->id());
      }
      fmt::print(out, "\n");
      for (const std::string& experiment : same.experiments) {
        fmt::print(out, "  to distinguish them: {}\n", experiment);
      }
    }
  }
  if (all_apart) {
    fmt::print(out, "all detectable effects can be distinguished from each other\n");
  }
}

}  // namespace host_sim::diagnose
