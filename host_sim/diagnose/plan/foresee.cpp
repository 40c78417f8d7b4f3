#include "host_sim/diagnose/plan/foresee.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/diagnose/force_records.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;
using hal::files::OutputError;

namespace {

// No campaign is better than this: calibration and rounding remain.
constexpr double kLeastNoise = 1e-3;  ///< of the input force
constexpr double kLeastScatter = 1e-3;

/// Noise of what one end reads, in N.
struct EndNoise {
  double relative_sd = 0;
  double absolute_N = 0;
  double ar1 = 0;

  [[nodiscard]] double variance_N2(double force_N) const {
    return std::pow(relative_sd * force_N, 2) + absolute_N * absolute_N;
  }
};

std::vector<effects::ForceRecord> simulated_records(synth::SynthPlan plan,
                                                    const ForeseeOptions& options) {
  plan.departures.clear();
  plan.lives.reset();
  plan.noise = {};
  plan.scatter = {};
  const ScratchFolder scratch;
  synth::make_campaign(plan, {options.seed, options.threads, options.progress}, scratch.path());
  const Campaign campaign = read_campaign(scratch.path());
  const auto recordings = recording::read_recordings(campaign.folder, campaign.columns);
  return force_records(recordings, recording::faults_of(recordings), campaign.nominal,
                       !campaign.two_sided);
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
        ids.push_back(audit.effects[member].effect->id);
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

NoiseModel noise_of(const synth::SynthPlan& plan, std::span<const effects::ForceRecord> records) {
  const EndNoise output{plan.noise.output.relative_sd, plan.noise.output.absolute_N,
                        plan.noise.output.ar1};
  NoiseModel noise;
  noise.session_gain_sd = std::max(plan.scatter.log_gain_sd, kLeastScatter);
  noise.session_friction_sd = std::max(plan.scatter.friction_sd, kLeastScatter);
  double all_N2 = 0;
  double passed_on_N2 = 0;
  for (const effects::ForceRecord& record : records) {
    const EndNoise input{plan.noise.input.relative_sd,
                         record.input_N_per_A > 0
                             ? plan.noise.input.absolute_A * record.input_N_per_A
                             : plan.noise.input.absolute_N,
                         plan.noise.input.ar1};
    std::vector<double>& sd_N = noise.sample_sd_N.emplace_back();
    for (std::size_t i = 0; i < record.samples(); ++i) {
      const double ratio = record.input_N[i] / record.output_N[i];
      const double of_input_N2 = input.variance_N2(record.input_N[i]);
      const double of_output_N2 = ratio * ratio * output.variance_N2(record.output_N[i]);
      const double least_N = kLeastNoise * record.input_N[i];
      sd_N.push_back(std::sqrt(std::max(of_input_N2 + of_output_N2, least_N * least_N)));
      all_N2 += of_input_N2 + of_output_N2;
      passed_on_N2 += of_input_N2 * input.ar1 + of_output_N2 * output.ar1;
    }
  }
  noise.autocorrelation = all_N2 > 0 ? passed_on_N2 / all_N2 : output.ar1;
  const double whitened = std::sqrt(1 - noise.autocorrelation * noise.autocorrelation);
  for (std::vector<double>& of_record : noise.sample_sd_N) {
    for (double& value_N : of_record) {
      value_N *= whitened;
    }
  }
  return noise;
}

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
  const std::vector<effects::ForceRecord> records = simulated_records(plan, options);
  if (records.empty()) {
    throw InputError(plan.file, 0, 0, "no session leaves a sample: nothing moves, or too little",
                     "travels_mm of at least 5");
  }
  Foresight foresight;
  foresight.noise = noise_of(plan, records);
  foresight.sessions = records.size();
  for (const effects::ForceRecord& record : records) {
    foresight.samples += static_cast<std::size_t>(std::ranges::count(record.used, true));
  }
  foresight.audit =
      audit(records, plan.model.sheath->friction_coefficient, foresight.noise, options.threads);
  return foresight;
}

std::string foresight_json(const Foresight& foresight) {
  ordered_json effects = ordered_json::array();
  ordered_json invisible = ordered_json::array();
  for (const EffectAudit& effect : foresight.audit.effects) {
    effects.push_back({{"id", effect.effect->id},
                       {"visible", effect.visible()},
                       {"share_left", effect.share},
                       {"standard_deviations", effect.sigmas},
                       {"words", effect.prose}});
    if (!effect.visible()) {
      invisible.push_back(effect.effect->id);
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
    fmt::print(out, "  {:<22}{}{}\n", effect->effect->id,
               effect->visible() ? "detectable: " : "not detectable: ", effect->prose);
  }
  bool all_apart = true;
  for (const EquivalenceClass& same : foresight.audit.classes) {
    if (same.members.size() > 1) {
      all_apart = false;
      fmt::print(out, "not distinguishable:");
      for (const std::size_t member : same.members) {
        fmt::print(out, " {}", foresight.audit.effects[member].effect->id);
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
