#include "host_sim/diagnose/tension/diagnose_recorded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "hal/files/input_error.hpp"
#include "host_sim/diagnose/audit.hpp"
#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "host_sim/diagnose/force/prose.hpp"
#include "host_sim/diagnose/tension/decision.hpp"
#include "host_sim/diagnose/tension/estimates.hpp"
#include "host_sim/diagnose/tension/held_out.hpp"
#include "host_sim/diagnose/tension/imitation.hpp"
#include "host_sim/diagnose/tension/model_fit.hpp"
#include "host_sim/diagnose/tension/noise.hpp"
#include "host_sim/diagnose/tension/pictures.hpp"
#include "host_sim/diagnose/tension/prose.hpp"
#include "host_sim/statistics/distribution.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;

namespace {

/// Relative; signatures of the largest effects leave as much.
constexpr double kFrictionOff = 0.01;

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

class Diagnoser {
 public:
  Diagnoser(const Campaign& campaign, const RecordedSessions& recorded,
            const DiagnoseOptions& options)
      : options_(options),
        constants_(constants_of(campaign.nominal)),
        wanted_(whole_catalogue(options.without)) {
    evidence_.sessions = recorded.sessions;
    evidence_.options.wanted.clear();
    evidence_.options.threads = options.threads;
    evidence_.options.kept = std::make_shared<KeptSignatures>(recorded.sessions.size());
    evidence_.options.baseline.friction_coefficient =
        settled_friction(recorded.sessions, campaign.nominal.sheath->friction_coefficient);
    evidence_.options.baseline.poses_rad = poses_of(recorded.sessions);
  }

  TensionDiagnosis run() {
    noise_ = sample_noise(evidence_.sessions, evidence_.options.baseline, wanted_, options_.threads,
                          evidence_.options.kept.get());
    evidence_.options.autocorrelation = noise_.autocorrelation;
    evidence_.options.weights = noise_.weights;
    evidence_.sample_sd = noise_.sample_sd;
    report(0.2);
    Grams grams = whole_grams();
    if (takes_friction_of(best_at_first(evidence_, grams))) {
      grams = whole_grams();
    }
    const Ranking ranking = rank(evidence_, grams);
    report(0.5);
    ResidualTests tests(probes_of(evidence_.sessions), options_.seed);
    const ResidualTest before = tests.of(evidence_, {});
    const Hypothesis& best = ranking.best();
    const ResidualTest after = best.parts.empty() ? before : tests.of(evidence_, best.parts);
    weighed_ = weigh(ranking, best, after);
    leave_out_imitations(ranking);
    report(0.6);
    TensionDiagnosis diagnosis;
    Findings& findings = diagnosis.findings;
    findings.candidates = weighed_.candidates;
    findings.credible_set = credible_set_of(weighed_.candidates);
    std::vector<Component> model = model_of(ranking);
    findings.verdict = verdict(model);
    const Audit audited = audit(grams, audit_noise(grams));
    model = refined(evidence_, std::move(model));
    add_discrepancies(before, model.empty() ? before : tests.of(evidence_, model), findings);
    add_audit(audited, findings);
    dispersion_ = dispersion_of(after);
    inlier_weights_ = weights_without_outliers(evidence_, model);
    inliers_ = evidence_;
    inliers_.options.weights = inlier_weights_;
    model = refined(inliers_, std::move(model));
    add_effects(model, findings);
    report(0.7);
    if (findings.verdict == Verdict::named && evidence_.sessions.size() >= kLeastSessions) {
      findings.gain = measure_gain(evidence_, model, constants_);
      withdraw_unless_improved(findings);
    }
    report(0.9);
    add_refitted(model, diagnosis);
    findings.next_experiment = next_experiment(findings, audited);
    findings.prose = verdict_prose(findings, evidence_.sessions.size());
    add_doubts(model, findings);
    findings.prose += no_gain_prose(findings);
    if (few()) {
      findings.prose += fmt::format(
          " {} of 4 sessions that it takes: the scatter between sessions is not known, and "
          "nothing can be named.",
          evidence_.sessions.size());
    }
    diagnosis.traces = trace_pictures(evidence_, model);
    diagnosis.session_refits = session_refits(evidence_);
    diagnosis.residuals = residual_pictures(evidence_, tests.probes(), model);
    report(1);
    return diagnosis;
  }

 private:
  void report(double share) const {
    if (options_.progress) {
      options_.progress(share);
    }
  }

  [[nodiscard]] Grams whole_grams() const {
    GramOptions all = evidence_.options;
    all.wanted = wanted_;
    return gram_of(evidence_.sessions, all);
  }

  /// Whether the friction of a hypothesis is so far from the one that it was found by that all have
  /// to be compared by it.
  bool takes_friction_of(const Hypothesis& hypothesis) {
    const double before = evidence_.options.baseline.friction_coefficient;
    take_friction_of(evidence_, hypothesis.parts);
    const double after = evidence_.options.baseline.friction_coefficient;
    return std::abs(after - before) > kFrictionOff * before;
  }

  [[nodiscard]] bool few() const { return evidence_.sessions.size() < kLeastSessions; }

  [[nodiscard]] Verdict verdict(std::span<const Component> model) const {
    const Verdict decided = decide(weighed_);
    const bool doubtful = few() || entangled(model) || confounded(model);
    return doubtful && decided == Verdict::named ? Verdict::ambiguous : decided;
  }

  /// What noise could imitate is taken out of the candidates, whose probability those without it
  /// get.
  void leave_out_imitations(const Ranking& ranking) {
    constexpr double kWorthTheTrouble = 0.01;
    std::vector<Candidate> left;
    for (Candidate& candidate : weighed_.candidates) {
      const Hypothesis* const hypothesis = hypothesis_of(ranking, candidate.id);
      if (hypothesis != nullptr && candidate.probability >= kWorthTheTrouble) {
        candidate.id =
            Hypothesis{.parts = beyond_noise(evidence_, hypothesis->parts), .log_evidence = 0}.id();
      }
      const auto same = std::ranges::find(left, candidate.id, &Candidate::id);
      if (same == left.end()) {
        left.push_back(candidate);
      } else {
        same->probability += candidate.probability;
      }
    }
    std::ranges::stable_sort(left, std::greater{}, &Candidate::probability);
    weighed_.candidates = std::move(left);
  }

  static const Hypothesis* hypothesis_of(const Ranking& ranking, std::string_view id) {
    for (const auto* list : {&ranking.singles, &ranking.pairs}) {
      const auto found = std::ranges::find(*list, id, &Hypothesis::id);
      if (found != list->end()) {
        return &*found;
      }
    }
    return nullptr;
  }

  /// Why a pair is not named for all its probability.
  static void add_doubts(std::span<const Component> model, Findings& findings) {
    if (findings.verdict != Verdict::ambiguous || !(entangled(model) || confounded(model))) {
      return;
    }
    findings.prose +=
        entangled(model)
            ? " Two effects at reversals do not add up, and one may stand for another of them."
            : " Two effects that are hard to distinguish may together stand for one that the "
              "catalogue does not have.";
    findings.next_experiment = experiment_for(*model.front().effect, *model.back().effect);
  }

  /// What pictures and estimates are of: the named model, or the first that is one.
  [[nodiscard]] std::vector<Component> model_of(const Ranking& ranking) const {
    if (decide(weighed_) == Verdict::none) {
      return {};
    }
    for (const Candidate& candidate : weighed_.candidates) {
      if (const Hypothesis* const found = hypothesis_of(ranking, candidate.id)) {
        return found->parts;
      }
    }
    return {};
  }

  /// The scatter that the sessions have beside the nominal model.
  [[nodiscard]] NoiseModel audit_noise(const Grams& grams) const {
    return fit_model(grams, {}, evidence_.sample_sd).noise;
  }

  static void add_discrepancies(const ResidualTest& before, const ResidualTest& after,
                                Findings& findings) {
    for (std::size_t i = 0; i < before.probes.size(); ++i) {
      findings.discrepancies.push_back({std::string(name_of(before.probes[i].of)),
                                        before.probes[i].statistic, before.probes[i].p,
                                        after.probes[i].p});
    }
  }

  static void add_audit(const Audit& audited, Findings& findings) {
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
        findings.equivalent_sets.push_back(std::move(ids));
      }
    }
  }

  void add_effects(std::span<const Component> model, Findings& findings) const {
    if (findings.verdict != Verdict::named && findings.verdict != Verdict::ambiguous) {
      return;
    }
    for (std::size_t i = 0; i < model.size(); ++i) {
      const effects::TensionEffect& effect = *model[i].effect;
      FoundEffect found{.id = std::string(effect.id()),
                        .term = std::string(effect.term()),
                        .equation = std::string(effect.equation()),
                        .life_consequence = std::string(effect.life_consequence()),
                        .probability = weighed_.marginal(effect.id()),
                        .parameters = estimates_of(inliers_, model, i, dispersion_)};
      if (findings.verdict == Verdict::named) {
        findings.extensions.push_back(
            extension_of(model[i], found.parameters, inliers_.options.baseline));
      }
      findings.effects.push_back(std::move(found));
    }
  }

  /// Gain or friction, by its place among the coefficients.
  static Estimate refitted(std::string name, const ModelFit& fit, Eigen::Index place,
                           double offset) {
    const double half = statistics::kNormal95 * std::sqrt(fit.covariance(place, place));
    const double value = offset + fit.coefficients(place);
    return {std::move(name), "1", value, value - half, value + half};
  }

  void add_refitted(std::span<const Component> model, TensionDiagnosis& diagnosis) const {
    const bool extended = diagnosis.findings.verdict == Verdict::named;
    const Fitted by = fitted(evidence_, extended ? model : std::span<const Component>{});
    const double gain_sd = by.fit.noise.session_gain_sd;
    const double friction_sd = by.fit.noise.session_friction_sd;
    const double baseline_mu = evidence_.options.baseline.friction_coefficient;
    diagnosis.findings.refitted = {
        refitted("friction_coefficient", by.fit, Eigen::Index{GramLayout::kFriction}, baseline_mu),
        refitted("log_gain", by.fit, Eigen::Index{GramLayout::kIntercept}, 0),
        {"session_gain_sd", "1", gain_sd, gain_sd, gain_sd},
        {"session_friction_sd", "1", friction_sd, friction_sd, friction_sd}};
    diagnosis.friction_coefficient = diagnosis.findings.refitted[0].value;
    diagnosis.log_gain = diagnosis.findings.refitted[1].value;
    if (extended) {
      diagnosis.damage_ratio =
          std::exp(mean_log_damage(fitted(evidence_, {})) - mean_log_damage(by));
    }
  }

  /// Of the input tension as a model has it from the output, mean of the sessions that do any.
  [[nodiscard]] double mean_log_damage(const Fitted& by) const {
    double sum = 0;
    double sessions = 0;
    for (const Session& session : evidence_.sessions) {
      const double damage = damage_of(predict(session, by).input_N, constants_);
      if (damage > 0) {
        sum += std::log(damage);
        sessions += 1;
      }
    }
    return sessions > 0 ? sum / sessions : 0;
  }

  const DiagnoseOptions& options_;
  reference::Constants constants_;
  std::vector<Wanted> wanted_;
  SampleNoise noise_;
  Evidence evidence_;
  Weighed weighed_;
  double dispersion_ = 1;
  SampleWeights inlier_weights_;
  Evidence inliers_;  ///< what estimates are of
};

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

/// Whether the forward model has something outside of the catalogue for what signatures found, or
/// excludes it.
bool doubted(const Findings& signatures, const TensionDiagnosis& forces) {
  return std::ranges::any_of(signatures.effects, [&](const FoundEffect& effect) {
    return std::ranges::find(forces.doubted, effect.id) != forces.doubted.end();
  });
}

/// Where signatures of ln T do not tell the cause of an error, effects in newtons may, or between
/// which it is; else they say how far it goes where it has none. What signatures name stands unless
/// that is doubted.
TensionDiagnosis in_newtons_after(TensionDiagnosis signatures, TensionDiagnosis forces) {
  Findings& found = forces.findings;
  const bool withdrawn = doubted(signatures.findings, forces);
  if (signatures.findings.verdict == Verdict::named && !withdrawn) {
    return signatures;
  }
  const bool more_is_told =
      found.verdict == Verdict::named ||
      (found.verdict == Verdict::ambiguous && signatures.findings.verdict == Verdict::unknown);
  if (withdrawn || more_is_told) {
    found.invisible = std::move(signatures.findings.invisible);
    for (std::vector<std::string>& set : signatures.findings.equivalent_sets) {
      const bool told = std::ranges::any_of(found.equivalent_sets, [&](const auto& other) {
        return std::ranges::is_permutation(set, other);
      });
      if (!told) {
        found.equivalent_sets.push_back(std::move(set));
      }
    }
    found.next_experiment = std::move(signatures.findings.next_experiment);
    return forces;
  }
  if (signatures.findings.verdict == Verdict::ambiguous ||
      signatures.findings.verdict == Verdict::none) {
    return signatures;
  }
  TensionDiagnosis& diagnosis = signatures;
  Findings& findings = diagnosis.findings;
  findings.remainder = std::move(found.remainder);
  findings.steps = std::move(found.steps);
  diagnosis.causes = std::move(forces.causes);
  findings.prose += how_far(findings.steps);
  diagnosis.remainders = std::move(forces.remainders);
  if (found.correction) {
    findings.correction = std::move(found.correction);
    findings.prose += correction_prose(*findings.correction);
    findings.extensions = std::move(found.extensions);
    findings.gain = std::move(found.gain);
    findings.refitted = std::move(found.refitted);
    diagnosis.traces = std::move(forces.traces);
    diagnosis.residuals.clear();  // of ln T, by a model without the correction
    diagnosis.damage_ratio = forces.damage_ratio;
    diagnosis.friction_coefficient = forces.friction_coefficient;
    diagnosis.log_gain = forces.log_gain;
  }
  return signatures;
}

/// With a part of the progress.
DiagnoseOptions part_of(DiagnoseOptions options, double from, double to) {
  if (options.progress) {
    options.progress = [from, to, report = std::move(options.progress)](double share) {
      report(std::lerp(from, to, share));
    };
  }
  return options;
}

}  // namespace

TensionDiagnosis diagnose_recorded(const Campaign& campaign, const RecordedSessions& recorded,
                                   const DiagnoseOptions& options) {
  const auto records = [&] {
    return force_records(recorded.recordings, recorded.faults, campaign.nominal,
                         !campaign.two_sided);
  };
  const auto in_newtons = [&](const std::vector<ForceRecord>& all, double from,
                              std::span<const FoundEffect> asked) {
    return diagnose_forces(all, campaign.nominal, constants_of(campaign.nominal),
                           part_of(options, from, 1), asked);
  };
  if (campaign.two_sided) {
    const std::vector<ForceRecord> all = records();
    return all.empty() ? nothing_to_see(recorded) : in_newtons(all, 0, {});
  }
  if (recorded.sessions.empty()) {
    return nothing_to_see(recorded);
  }
  if (!campaign.nominal.sheath) {
    throw InputError((campaign.folder / "campaign.toml").string(), 0, 0,
                     "no table [model.sheath], which residuals are taken from",
                     "[model.sheath] with friction_coefficient and bend_angle_deg");
  }
  constexpr double kOfSignatures = 0.4;
  const DiagnoseOptions first = part_of(options, 0, kOfSignatures);
  TensionDiagnosis diagnosis = Diagnoser(campaign, recorded, first).run();
  const Findings& findings = diagnosis.findings;
  const std::span<const FoundEffect> asked =
      findings.verdict == Verdict::named ? findings.effects : std::span<const FoundEffect>{};
  TensionDiagnosis forces = in_newtons(records(), kOfSignatures, asked);
  return in_newtons_after(std::move(diagnosis), std::move(forces));
}

TensionDiagnosis diagnose_tension(const Campaign& campaign, const DiagnoseOptions& options) {
  return diagnose_recorded(campaign, recorded_sessions(campaign), options);
}

}  // namespace host_sim::diagnose
