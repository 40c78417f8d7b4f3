#include "host_sim/diagnose/force/diagnose_forces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "host_sim/diagnose/force/doubts.hpp"
#include "host_sim/diagnose/force/extended_model.hpp"
#include "host_sim/diagnose/force/force_candidates.hpp"
#include "host_sim/diagnose/force/force_pictures.hpp"
#include "host_sim/diagnose/force/force_search.hpp"
#include "host_sim/diagnose/force/invisible.hpp"
#include "host_sim/diagnose/force/prose.hpp"
#include "host_sim/diagnose/force/remainder.hpp"
#include "host_sim/extension/model_file.hpp"

namespace host_sim::diagnose {
namespace {

/// How much further parameters are off than their sessions scatter, where what is left is no
/// chance: as much as in simulated campaigns that hide more than is named.
constexpr double kBesideRemainder = 2;

/// Of an effect that is seen, and by the intervals of its parameters may be none.
constexpr double kEven = 0.5;

class Report {
 public:
  /// @param records with all samples
  /// @param doubts of them without a model
  Report(const ForceData& data, std::span<const effects::ForceRecord> records,
         const ForceSearch& search, const NominalModel& nominal,
         const reference::Constants& constants, std::vector<Doubt> doubts,
         const DiagnoseOptions& options)
      : data_(data),
        search_(search),
        stairs_(search.stairs()),
        constants_(constants),
        models_(data, search),
        doubts_(std::move(doubts)),
        remainder_(remainder_of(data, search.nominal().fit, search.model().fit, search.covariates(),
                                search.bins(), options.seed)),
        half_(search.half_widths(remainder_.stands ? kBesideRemainder : 1)),
        judged_(search.judged()),
        audit_(audit_of(data, search.model().fit, options.threads)) {
    const std::vector<bool> none = search.may_be_none(remainder_.stands ? kBesideRemainder : 1);
    for (std::size_t i = 0; i < judged_.size(); ++i) {
      if (none[i]) {
        judged_[i].share = std::min(judged_[i].share, kEven);
      }
    }
    constexpr double kMuchLeft = 0.3;
    if (!spoilt()) {
      const bool much = (remainder_.stands && judged_.empty()) || share_left() > kMuchLeft;
      std::ranges::move(doubts_beside(data, records, search.model().fit, nominal, much),
                        std::back_inserter(doubts_));
    }
  }

  TensionDiagnosis diagnosis() {
    TensionDiagnosis diagnosis;
    Findings& findings = diagnosis.findings;
    if (!judged_.empty() && !names_nothing()) {
      findings.gain = gain_of({search_.model().fit, search_.model().held.residuals_N});
      if (remainder_.stands && std::ranges::all_of(judged_, is_alone) && !improves(findings.gain)) {
        judged_.clear();  // what is left is no less than without them
      }
    }
    findings.verdict = verdict();
    findings.candidates = candidates(findings.verdict);
    findings.credible_set = credible_set_of(findings.candidates);
    add_effects(findings);
    findings.steps = steps();
    findings.remainder =
        Remainder{.share = share_left(),
                  .input_rmse_N = search_.rmse_N(),
                  .output_rmse_N = models_.output_rmse_N({search_.model().fit, {}}),
                  .covariate = std::string(remainder_.covariate),
                  .p = remainder_.p};
    findings.doubts = doubts_;
    findings.prose =
        verdict_prose(findings, data_.records().size(), search_.nominal_rmse_N(), spoilt());
    for (const Judged& one : judged_) {
      if (one.imitated_by) {
        findings.prose += imitation_prose(law_of(one.term), law_of(*one.imitated_by));
      } else if (findings.verdict == Verdict::named && is_doubtful(one)) {
        findings.prose += doubtful_prose(law_of(one.term), probability_of(one));
      }
    }
    if (withdraw_unless_improved(findings)) {
      findings.prose += no_gain_prose(findings);
    }
    extend(diagnosis);
    add_invisible(audit_, findings);
    findings.discrepancies = remainder_.discrepancies;
    diagnosis.remainders = remainder_.pictures;
    add_pictures(diagnosis);
    return diagnosis;
  }

 private:
  [[nodiscard]] bool spoilt() const { return spoil_all(doubts_); }

  [[nodiscard]] bool names_nothing() const {
    return data_.records().size() < kLeastSessions || spoilt();
  }

  [[nodiscard]] Verdict verdict() const {
    if (judged_.empty() || names_nothing()) {
      return remainder_.stands || spoilt() ? Verdict::unknown : Verdict::none;
    }
    if (std::ranges::any_of(judged_, [&](const Judged& one) { return stands(one); })) {
      return Verdict::named;
    }
    return std::ranges::all_of(judged_,
                               [](const Judged& one) { return one.imitated_by.has_value(); })
               ? Verdict::unknown
               : Verdict::ambiguous;
  }

  /// Of the squared error of the nominal model.
  [[nodiscard]] double share_left() const {
    const double left = search_.rmse_N() / search_.nominal_rmse_N();
    return left * left;
  }

  /// By itself: nothing could be in its place.
  [[nodiscard]] static bool is_alone(const Judged& one) {
    return one.others.empty() && !one.imitated_by;
  }

  [[nodiscard]] double probability_of(const Judged& one) const {
    return diagnose::probability_of(one.term, one.gain, data_) * one.share;
  }

  [[nodiscard]] bool stands(const Judged& one) const {
    return is_alone(one) && probability_of(one) >= kNamed;
  }

  [[nodiscard]] bool is_doubtful(const Judged& one) const { return is_alone(one) && !stands(one); }

  [[nodiscard]] std::vector<Candidate> candidates(Verdict verdict) const {
    const bool none =
        verdict == Verdict::none || (verdict == Verdict::ambiguous && !remainder_.stands);
    const std::string rest = none ? "none" : "unknown";
    return names_nothing() ? candidates_of(data_, {}, {}, rest, remainder_.stands)
                           : candidates_of(data_, judged_, left_out(), rest, remainder_.stands);
  }

  [[nodiscard]] std::vector<LeftOut> left_out() const {
    std::vector<LeftOut> all = search_.left_out();
    for (LeftOut& one : all) {
      one.unseen = unseen_probability(audit_.of(law_of(one.term).id()).sigmas);
    }
    return all;
  }

  /// A term with its parameters, but for its probability.
  /// @param half 95 % half-widths of the parameters of the model
  [[nodiscard]] FoundEffect effect_of(effects::ForceTerm term, const ForceFit& model,
                                      std::span<const double> half) const {
    const effects::ForceLaw& of = law_of(term);
    FoundEffect found{.id = std::string(of.id()),
                      .term = std::string(of.term()),
                      .equation = std::string(of.equation),
                      .life_consequence = std::string(of.effect->life_consequence),
                      .probability = 0,
                      .parameters = {}};
    std::size_t next = 2;
    for (const effects::ForceTerm before : model.terms) {
      for (const effects::ForceParameter& parameter : parameters_of(before, data_.scales())) {
        const double value = model.parameters[next];
        if (before == term) {
          found.parameters.push_back({std::string(parameter.name), std::string(parameter.unit),
                                      value, value - half[next], value + half[next]});
        }
        ++next;
      }
    }
    return found;
  }

  void add_effects(Findings& findings) const {
    if (findings.verdict != Verdict::named && findings.verdict != Verdict::ambiguous) {
      return;
    }
    for (const Judged& one : judged_) {
      FoundEffect found = effect_of(one.term, search_.model().fit, half_);
      found.probability = probability_of(one);
      if (!one.others.empty()) {
        std::vector<std::string> same{found.id};
        for (const Judged::Other& other : one.others) {
          if (const std::string_view id = law_of(other.term).id();
              std::ranges::find(same, id) == same.end()) {
            same.emplace_back(id);
          }
        }
        findings.equivalent_sets.push_back(std::move(same));
      }
      if (findings.verdict == Verdict::named ? stands(one) : !one.imitated_by) {
        findings.effects.push_back(std::move(found));
      }
    }
  }

  /// ln, of a sample beside the gain and friction that scatter between sessions.
  /// @param held_N residuals on sessions that the fit never saw
  [[nodiscard]] double density(const std::vector<std::vector<double>>& held_N) const {
    double square_N2 = 0;
    for (std::size_t j = 0; j < held_N.size(); ++j) {
      square_N2 += data_.covariance().product(j, vector_of(held_N[j]), vector_of(held_N[j]))(0, 0);
    }
    return -std::log(2 * std::numbers::pi * square_N2 / data_.samples()) / 2 - 0.5;
  }

  [[nodiscard]] std::vector<Step> steps() const {
    std::vector<Step> steps;
    for (std::size_t i = 0; i < stairs_.size(); ++i) {
      const double rmse_N = data_.rmse_N(stairs_[i].held.plain_N2);
      Step step{.effect = {},
                .output_rmse_N = models_.output_rmse_N({stairs_[i].fit, {}}),
                .input_rmse_N = rmse_N,
                .log_predictive_density = density(stairs_[i].held.residuals_N),
                .sessions = static_cast<int>(data_.records().size())};
      if (i > 0) {
        const std::vector<double>& before_N2 = stairs_[i - 1].held.beside_scatter_N2;
        step.effect = effect_of(stairs_[i].fit.terms.back(), stairs_[i].fit,
                                data_.half_widths(stairs_[i].fit));
        step.effect.probability = diagnose::probability_of(
            stairs_[i].fit.terms.back(),
            paired_gain(data_, stairs_[i - 1].held, stairs_[i].held, true), data_);
        for (std::size_t j = 0; j < before_N2.size(); ++j) {
          step.sessions_better += stairs_[i].held.beside_scatter_N2[j] < before_N2[j] ? 1 : 0;
        }
      }
      steps.push_back(std::move(step));
    }
    return steps;
  }

  [[nodiscard]] double rmse_N(const std::vector<std::vector<double>>& residuals_N) const {
    return data_.rmse_N(data_.mean_squares_N2(residuals_N));
  }

  [[nodiscard]] HeldOutGain gain_of(const ExtendedModel& extended) const {
    const double before = search_.nominal_rmse_N();
    const double after = rmse_N(extended.held_N);
    HeldOutGain gain{
        .held_out_by = "session",
        .metrics = {{"rmse_N", models_.output_rmse_N({search_.nominal().fit, {}}),
                     models_.output_rmse_N(extended)},
                    {"input_rmse_N", before, after},
                    {"log_predictive_density", density(search_.nominal().held.residuals_N),
                     density(extended.held_N)}},
        .within_scatter =
            within_scatter(paired_gain(data_, search_.nominal().held, search_.model().held, true))};
    const std::optional<double> damage_before =
        damage_error_percent(search_.nominal().held.residuals_N);
    const std::optional<double> damage_after = damage_error_percent(extended.held_N);
    if (damage_before && damage_after) {
      gain.metrics.push_back({"damage_error_percent", *damage_before, *damage_after});
    }
    return gain;
  }

  /// Magnitude of the error of the damage of a session, mean of those that do any; none of forces
  /// that two tendons share.
  [[nodiscard]] std::optional<double> damage_error_percent(
      const std::vector<std::vector<double>>& residuals_N) const {
    constexpr double kPercent = 100;
    double sum = 0;
    double sessions = 0;
    for (std::size_t j = 0; j < residuals_N.size(); ++j) {
      const effects::ForceRecord& record = data_.records()[j];
      std::vector<double> predicted_N = record.input_N;
      for (std::size_t i = 0; i < predicted_N.size(); ++i) {
        predicted_N[i] -= residuals_N[j][i];
      }
      const double measured = record.pulls_alone ? damage_of(record.input_N, constants_) : 0;
      if (measured > 0) {
        sum += std::abs(damage_of(predicted_N, constants_) / measured - 1);
        sessions += 1;
      }
    }
    return sessions > 0 ? std::optional(kPercent * sum / sessions) : std::nullopt;
  }

  /// What the causes leave, and without any the nominal model, gets a correction. A written model
  /// holds that and what of the causes it can; of some that could be each other's it holds one.
  void extend(TensionDiagnosis& diagnosis) {
    Findings& findings = diagnosis.findings;
    const bool named = findings.verdict == Verdict::named;
    // It is one of some causes, by each of which the model gains as much.
    const bool between = findings.verdict == Verdict::ambiguous && improves(findings.gain);
    const ForceSearch::Candidate& by = named || between ? search_.model() : search_.nominal();
    extended_ = {by.fit, by.held.residuals_N};
    if (findings.verdict != Verdict::none && !names_nothing()) {
      extended_ = models_.corrected(std::move(extended_));
    }
    const ExtendedModel written = models_.written(extended_);
    for (std::size_t i = 0; i < written.fit.terms.size(); ++i) {
      findings.extensions.push_back(
          *written_term(written.fit.terms[i],
                        parameters_at(i, written.fit.terms, written.fit.parameters, data_.scales()),
                        data_.scales()));
    }
    if (named) {
      findings.prose += left_out_prose(findings, written);
    }
    add_refitted(written.fit, diagnosis);
    if (between && !findings.equivalent_sets.empty() && !findings.extensions.empty()) {
      findings.prose += either_way_prose(written.fit.terms);
    }
    if (written.correction) {
      findings.extensions.push_back(
          written_correction(*written.correction, written.fit.parameters[0]));
    }
    if (extended_.correction) {
      findings.gain = gain_of(extended_);
      findings.correction = Correction{
          .covariate = std::string(search_.covariates()[extended_.correction->covariate].name),
          .knots = extended_.correction->table.knots.size(),
          .before_N = data_.rmse_N(by.held.plain_N2),
          .after_N = rmse_N(extended_.held_N)};
      findings.prose += correction_prose(*findings.correction);
    }
    if (!findings.extensions.empty()) {
      diagnosis.damage_ratio = models_.damage_ratio(extended_, constants_);
    }
  }

  /// What of the causes a file cannot hold, and how good a model is without.
  [[nodiscard]] std::string left_out_prose(const Findings& findings,
                                           const ExtendedModel& written) const {
    std::vector<std::string> left_out;
    for (const FoundEffect& effect : findings.effects) {
      const bool held = std::ranges::any_of(written.fit.terms, [&](effects::ForceTerm term) {
        return law_of(term).id() == effect.id;
      });
      if (!held) {
        left_out.push_back(effect.term);
      }
    }
    return left_out.empty() ? ""
                            : not_written_prose(left_out, written.correction.has_value(),
                                                rmse_N(written.held_N));
  }

  void add_refitted(const ForceFit& model, TensionDiagnosis& diagnosis) const {
    const std::vector<double> half = data_.half_widths(model);
    const double gain = model.parameters[0];
    const double friction = model.parameters[1];
    const double gain_sd = data_.covariance().log_gain_sd();
    const double friction_sd = data_.covariance().friction_sd();
    diagnosis.findings.refitted = {
        {"friction_coefficient", "1", friction, friction - half[1], friction + half[1]},
        {"log_gain", "1", -std::log(gain), -std::log(gain) - half[0] / gain,
         -std::log(gain) + half[0] / gain},
        {"session_gain_sd", "1", gain_sd, gain_sd, gain_sd},
        {"session_friction_sd", "1", friction_sd, friction_sd, friction_sd}};
    diagnosis.friction_coefficient =
        written_friction(friction, diagnosis.findings.extensions, data_.scales());
    diagnosis.log_gain = -std::log(gain);
  }

  [[nodiscard]] PicturedModel pictured(const ExtendedModel& model) const {
    return {model.fit.parameters[0], models_.left_N(model)};
  }

  void add_pictures(TensionDiagnosis& diagnosis) const {
    const ForceFit& nominal = search_.nominal().fit;
    diagnosis.traces = traces_of(data_, pictured({nominal, {}}), pictured(extended_));
    std::vector<PicturedModel> stairs;
    for (const ForceSearch::Candidate& one : stairs_) {
      stairs.push_back(pictured({one.fit, {}}));
    }
    diagnosis.causes = causes_of(data_, stairs, diagnosis.findings.steps);
    diagnosis.session_refits = session_refits_of(data_, nominal);
  }

  const ForceData& data_;
  const ForceSearch& search_;
  std::vector<ForceSearch::Candidate> stairs_;
  const reference::Constants& constants_;
  ModelExtension models_;
  std::vector<Doubt> doubts_;
  ForceRemainder remainder_;
  std::vector<double> half_;  ///< 95 % half-widths of the parameters of the model
  std::vector<Judged> judged_;
  Audit audit_;
  ExtendedModel extended_;
};

}  // namespace

TensionDiagnosis diagnose_forces(const std::vector<effects::ForceRecord>& records,
                                 const NominalModel& nominal, const reference::Constants& constants,
                                 const DiagnoseOptions& options) {
  std::vector<Doubt> doubts = doubts_of(records, nominal);
  const std::vector<effects::ForceRecord> sound = sound_of(records, doubts);
  ForceData data(sound);
  ForceSearch search(data, sound, nominal.sheath ? nominal.sheath->friction_coefficient : 0.1,
                     options);
  search.run();
  return Report(data, sound, search, nominal, constants, std::move(doubts), options).diagnosis();
}

}  // namespace host_sim::diagnose
