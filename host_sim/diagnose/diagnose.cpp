#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/diagnose/audit/audit.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "host_sim/diagnose/force/remainder.hpp"
#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::diagnose {

using hal::files::in_quotes;
using hal::files::InputError;

namespace {

bool has_recordings(const Campaign& campaign) {
  return is_there(campaign.folder / "sessions.csv");
}

/// Effects are told apart by lives; what is known of the others here would say more than it does.
void refuse_unknown_lives(const Campaign& campaign) {
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (specimen.trimmed() || specimen.found_broken()) {
      throw InputError(
          (campaign.folder / "specimens.csv").string(), specimen.line, 0,
          fmt::format("specimen {} was {}", in_quotes(specimen.name),
                      specimen.trimmed() ? "trimmed" : "found broken at an inspection"),
          "failed and suspended specimens for diagnose; calibrate takes the others");
    }
  }
}

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

/// What the campaign could show, with the friction and the noise that its diagnosis found.
Audit audit_of(std::span<const Session> sessions, const TensionDiagnosis& diagnosis,
               const DiagnoseOptions& options) {
  GramOptions gram;
  gram.baseline.friction_coefficient = diagnosis.nominal_friction;
  gram.without = options.without;
  gram.threads = options.threads;
  double samples = 0;
  for (const Session& session : sessions) {
    samples += static_cast<double>(session.covariates.samples());
  }
  constexpr double kLeast_sd = 1e-6;
  return audit(gram_of(sessions, gram),
               {.sample_sd = std::max(diagnosis.log_gain_error * std::sqrt(samples), kLeast_sd),
                .session_gain_sd = diagnosis.session_gain_sd,
                .session_friction_sd = diagnosis.session_friction_sd});
}

void add_audit(const Audit& audited, Findings& findings) {
  for (const EffectAudit& effect : audited.effects) {
    if (!effect.visible()) {
      findings.invisible.push_back({std::string(effect.effect->id()), effect.prose});
    }
  }
  for (const EquivalenceClass& group : audited.classes) {
    if (group.members.size() > 1) {
      std::vector<std::string> ids;
      for (const std::size_t member : group.members) {
        ids.emplace_back(audited.effects[member].effect->id());
      }
      const bool known = std::ranges::any_of(findings.equivalent_sets, [&](const auto& same) {
        return std::ranges::is_permutation(same, ids);
      });
      if (!known) {
        findings.equivalent_sets.push_back(std::move(ids));
      }
    }
  }
}

const effects::TensionEffect* effect_of(std::string_view id) {
  for (const auto& effect : effects::tension_effects()) {
    if (effect->id() == id) {
      return effect.get();
    }
  }
  return nullptr;
}

/// What distinguishes causes that are still in question, or shows one that is not known.
std::string next_experiment(const Findings& findings) {
  if (findings.verdict == Verdict::unknown && !findings.discrepancies.empty()) {
    const auto rarest = std::ranges::min_element(findings.discrepancies, {}, &Discrepancy::p_after);
    return rarest->covariate == kSession
               ? "repeat a few sessions with nothing changed, and note what else differs between "
                 "them"
               : fmt::format("repeat a few sessions with nothing changed but the {}",
                             rarest->covariate);
  }
  if (findings.verdict == Verdict::ambiguous && !findings.equivalent_sets.empty()) {
    const std::vector<std::string>& same = findings.equivalent_sets.front();
    const effects::TensionEffect* const one = effect_of(same[0]);
    const effects::TensionEffect* const other = effect_of(same[1]);
    return one != nullptr && other != nullptr
               ? experiment_for(*one, *other)
               : fmt::format("record {} and {} at several speeds and loads", same[0], same[1]);
  }
  return findings.verdict == Verdict::ambiguous && !findings.effects.empty()
             ? fmt::format(
                   "record more sessions in which {} would show: a wider range of what it "
                   "depends on, at the same poses and loads",
                   findings.effects.front().term)
             : "";
}

TensionDiagnosis diagnose_recorded(const Campaign& campaign, const RecordedSessions& recorded,
                                   const DiagnoseOptions& options) {
  const bool pulls_alone = !campaign.two_sided;
  if (pulls_alone && recorded.sessions.empty()) {
    return nothing_to_see(recorded);
  }
  if (pulls_alone && !campaign.nominal.sheath) {
    throw InputError((campaign.folder / "campaign.toml").string(), 0, 0,
                     "no table [model.sheath], which residuals are taken from",
                     "[model.sheath] with friction_coefficient and bend_angle_deg");
  }
  const std::vector<ForceRecord> records =
      force_records(recorded.recordings, recorded.faults, campaign.nominal, pulls_alone);
  if (records.empty()) {
    return nothing_to_see(recorded);
  }
  TensionDiagnosis diagnosis =
      diagnose_forces(records, campaign.nominal, constants_of(campaign.nominal), options);
  Findings& findings = diagnosis.findings;
  findings.next_experiment = next_experiment(findings);
  if (pulls_alone) {  // signatures are of the logarithm of a force
    add_audit(audit_of(recorded.sessions, diagnosis, options), findings);
  }
  if (options.progress) {
    options.progress(1);
  }
  return diagnosis;
}

}  // namespace

Diagnosis diagnose(const Campaign& campaign, const DiagnoseOptions& options) {
  refuse_unknown_lives(campaign);
  Diagnosis diagnosis;
  if (has_recordings(campaign)) {
    const RecordedSessions recorded = recorded_sessions(campaign);
    for (const recording::FaultSummary& summary : recording::summary_of(recorded.faults)) {
      diagnosis.warnings.push_back(summary.words);
    }
    diagnosis.tension = diagnose_recorded(campaign, recorded, options);
  }
  if (!campaign.specimens.empty()) {
    diagnosis.lives = diagnose_lives(campaign, options);
  }
  return diagnosis;
}

TensionDiagnosis diagnose_tension(const Campaign& campaign, const DiagnoseOptions& options) {
  return diagnose_recorded(campaign, recorded_sessions(campaign), options);
}

}  // namespace host_sim::diagnose
