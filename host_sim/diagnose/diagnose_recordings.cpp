#include "host_sim/diagnose/diagnose_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/diagnose/audit/audit.hpp"
#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "host_sim/diagnose/force/remainder.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;

namespace {

/// Of the paper's wire, where the campaign does not say: damage is compared with damage only.
constexpr reference::Constants kUsualWire{177.4, 0.2, 1.53e5, 1.38, 5.94};

reference::Constants constants_of(const NominalModel& nominal) {
  reference::Constants constants = kUsualWire;
  if (nominal.cable) {
    constants.ultimate_tension_N = nominal.cable->ultimate_tension_N;
  }
  if (nominal.counting) {
    constants.hysteresis_N = nominal.counting->hysteresis_N;
  }
  if (nominal.life) {
    constants.ipl_scale = nominal.life->ipl_scale;
    constants.ipl_exponent = nominal.life->ipl_exponent;
  }
  return constants;
}

TensionDiagnosis nothing_to_see(const RecordedSessions& recorded) {
  TensionDiagnosis diagnosis;
  diagnosis.findings.candidates = {{"none", 1}};
  diagnosis.findings.credible_set = {"none"};
  diagnosis.findings.prose =
      recorded.faults.empty()
          ? "The recordings contain no motion from which friction could be determined: nothing can "
            "be diagnosed."
          : "Nothing is left of the recordings once the faults of their sensors are taken out: "
            "nothing can be diagnosed.";
  for (const auto& effect : effects::tension_effects()) {
    diagnosis.findings.invisible.push_back(
        {std::string(effect->id()), "no recording with motion and both tensions"});
  }
  return diagnosis;
}

/// Noise of ln T_out - ln T_in, root mean square of all samples.
double sample_sd_of(const std::vector<Session>& sessions) {
  double square = 0;
  double samples = 0;
  for (const Session& session : sessions) {
    const recording::Covariates& covariates = session.covariates;
    for (const auto* const noise : {&covariates.input_noise, &covariates.output_noise}) {
      for (const double variance : *noise) {
        square += variance;
      }
    }
    samples += static_cast<double>(covariates.samples());
  }
  return std::sqrt(square / std::max(samples, 1.0));
}

double refitted(const Findings& findings, std::string_view name) {
  return std::ranges::find(findings.refitted, name, &Estimate::name)->value;
}

/// By the friction and the scatter of sessions that a diagnosis has found.
Audit audit_of(const std::vector<Session>& sessions, const TensionDiagnosis& diagnosis,
               unsigned threads) {
  NoiseModel noise;
  noise.sample_sd = std::max(sample_sd_of(sessions), kLeastNoise.sample_sd);
  noise.session_gain_sd =
      std::max(refitted(diagnosis.findings, "session_gain_sd"), kLeastNoise.session_gain_sd);
  noise.session_friction_sd = std::max(refitted(diagnosis.findings, "session_friction_sd"),
                                       kLeastNoise.session_friction_sd);
  GramOptions options;
  options.baseline.friction_coefficient = diagnosis.friction_coefficient;
  options.threads = threads;
  return audit(gram_of(sessions, options), noise);
}

void add_audit(const Audit& audited, Findings& findings) {
  for (const EffectAudit& effect : audited.effects) {
    if (!effect.visible()) {
      findings.invisible.push_back({std::string(effect.effect->id()), effect.prose});
    }
  }
  for (const EquivalenceClass& group : audited.classes) {
    std::vector<std::string> ids;
    for (const std::size_t member : group.members) {
      ids.emplace_back(audited.effects[member].effect->id());
    }
    const bool known = std::ranges::any_of(findings.equivalent_sets, [&](const auto& other) {
      return std::ranges::is_permutation(ids, other);
    });
    if (ids.size() > 1 && !known) {
      findings.equivalent_sets.push_back(std::move(ids));
    }
  }
}

/// The first effect of one candidate that the other does not hold; null where there is none.
const effects::TensionEffect* other_than(std::string_view one, std::string_view other) {
  const std::vector<std::string_view> known = effects_in(other);
  for (const std::string_view id : effects_in(one)) {
    for (const auto& effect : effects::tension_effects()) {
      if (effect->id() == id && std::ranges::find(known, id) == known.end()) {
        return effect.get();
      }
    }
  }
  return nullptr;
}

/// What distinguishes the causes that are still in question; empty where none are.
std::string next_experiment(const Findings& findings) {
  if (findings.verdict == Verdict::unknown && findings.remainder) {
    const std::string& covariate = findings.remainder->covariate;
    return covariate == kOfTime || covariate == kSession
               ? "repeat one session several times with nothing changed"
               : fmt::format("repeat a few sessions with nothing changed but the {}", covariate);
  }
  if (findings.verdict != Verdict::ambiguous || findings.credible_set.size() < 2) {
    return "";
  }
  const std::string& first = findings.credible_set[0];
  const std::string& second = findings.credible_set[1];
  const effects::TensionEffect* one = other_than(first, second);
  const effects::TensionEffect* other = other_than(second, first);
  if (one != nullptr && other != nullptr) {
    return experiment_for(*one, *other);
  }
  const effects::TensionEffect* doubtful = one != nullptr ? one : other;
  return doubtful == nullptr
             ? ""
             : fmt::format(
                   "record more sessions in which {} would show: a wider range of what it "
                   "depends on, at the same poses and loads",
                   doubtful->term());
}

}  // namespace

TensionDiagnosis diagnose_recordings(const Campaign& campaign, const RecordedSessions& recorded,
                                     const DiagnoseOptions& options) {
  if (!campaign.two_sided && recorded.sessions.empty()) {
    return nothing_to_see(recorded);
  }
  if (!campaign.two_sided && !campaign.nominal.sheath) {
    throw InputError((campaign.folder / "campaign.toml").string(), 0, 0,
                     "no table [model.sheath], which friction is compared with",
                     "[model.sheath] with friction_coefficient and bend_angle_deg");
  }
  const std::vector<ForceRecord> records =
      force_records(recorded.recordings, recorded.faults, campaign.nominal, !campaign.two_sided);
  if (records.empty()) {
    return nothing_to_see(recorded);
  }
  TensionDiagnosis diagnosis =
      diagnose_forces(records, campaign.nominal, constants_of(campaign.nominal), options);
  if (!campaign.two_sided) {
    add_audit(audit_of(recorded.sessions, diagnosis, options.threads), diagnosis.findings);
  }
  diagnosis.findings.next_experiment = next_experiment(diagnosis.findings);
  return diagnosis;
}

TensionDiagnosis diagnose_tension(const Campaign& campaign, const DiagnoseOptions& options) {
  return diagnose_recordings(campaign, recorded_sessions(campaign), options);
}

}  // namespace host_sim::diagnose
