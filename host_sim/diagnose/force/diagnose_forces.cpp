#include "host_sim/diagnose/force/diagnose_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "host_sim/diagnose/force/correction.hpp"
#include "host_sim/diagnose/force/force_search.hpp"
#include "host_sim/diagnose/force/prose.hpp"
#include "host_sim/diagnose/force/remainder.hpp"
#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/extension/model_file.hpp"

namespace host_sim::diagnose {
namespace {

/// The probability that what is named is all that is wrong, where what is left is no chance: that
/// has a cause of its own as likely as not.
constexpr double kOnlyCauses = 0.5;

/// How much further parameters are off than their sessions scatter, where what is left is no
/// chance: as much as in simulated campaigns that hide more than is named.
constexpr double kBesideRemainder = 2;

/// The error of the output force that one of the input force is, sample by sample.
double output_rmse_N(const ForceData& data, const ForceFit& model,
                     const std::vector<std::vector<double>>& residuals_N) {
  constexpr double kStep = 1e-3;
  const double step_N = kStep * data.scales().force_N;
  double square_N2 = 0;
  std::vector<double> at;
  std::vector<double> above;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    ForceRecord moved = data.records()[j];
    predict_input(moved, data.kinematics()[j], model.terms, data.scales(), model.parameters, at);
    for (double& output_N : moved.output_N) {
      output_N += step_N;
    }
    predict_input(moved, data.kinematics()[j], model.terms, data.scales(), model.parameters, above);
    for (std::size_t i = 0; i < at.size(); ++i) {
      constexpr double kLeastSlope = 0.05;
      const double slope = std::max((above[i] - at[i]) / step_N, kLeastSlope);
      square_N2 += residuals_N[j][i] * residuals_N[j][i] / (slope * slope);
    }
  }
  return std::sqrt(square_N2 / data.samples());
}

/// A model as it is judged and as it is written.
struct Extended {
  ForceFit fit;
  std::vector<std::vector<double>> held_N;  ///< residuals on sessions that the fit never saw
  std::optional<ForceCorrection> correction;
};

class Report {
 public:
  Report(const ForceData& data, const ForceSearch& search, const NominalModel& nominal,
         const reference::Constants& constants, std::uint64_t seed)
      : data_(data),
        search_(search),
        stairs_(search.stairs()),
        nominal_(nominal),
        constants_(constants),
        covariates_(search.covariates()),
        remainder_(remainder_of(data, search.nominal().fit, search.model().fit, covariates_,
                                search.bins(), seed)) {}

  TensionDiagnosis diagnosis() {
    TensionDiagnosis diagnosis;
    Findings& findings = diagnosis.findings;
    findings.verdict = verdict();
    add_candidates(findings);
    add_effects(findings);
    findings.steps = steps();
    if (!search_.judged().empty() && !few()) {
      findings.gain =
          gain_of({search_.model().fit, search_.model().held.residuals_N, std::nullopt});
    }
    findings.remainder =
        Remainder{.share = share_left(),
                  .input_rmse_N = search_.rmse_N(),
                  .output_rmse_N = output_rmse_of({search_.model().fit, {}, std::nullopt}),
                  .covariate = std::string(remainder_.covariate),
                  .p = remainder_.p};
    findings.prose = verdict_prose(findings, data_.records().size(), search_.nominal_rmse_N()) +
                     doubts(data_.records(), search_.model().fit.parameters, nominal_);
    for (const Judged& one : search_.judged()) {
      if (one.imitated_by) {
        findings.prose += imitation_prose(definition_of(one.term), definition_of(*one.imitated_by));
      } else if (findings.verdict == Verdict::named && is_doubtful(one)) {
        findings.prose +=
            doubtful_prose(definition_of(one.term), probability_of(one.term, one.gain, data_));
      }
    }
    if (withdraw_unless_improved(findings)) {
      findings.prose += no_gain_prose(findings);
    }
    extend(diagnosis);
    add_traces(diagnosis);
    add_causes(diagnosis);
    findings.discrepancies = remainder_.discrepancies;
    diagnosis.remainders = remainder_.pictures;
    diagnosis.session_refits = session_refits();
    return diagnosis;
  }

 private:
  [[nodiscard]] bool few() const { return data_.records().size() < kLeastSessions; }

  [[nodiscard]] Verdict verdict() const {
    const auto& judged = search_.judged();
    if (judged.empty() || few()) {
      return remainder_.stands ? Verdict::unknown : Verdict::none;
    }
    if (std::ranges::any_of(judged, [&](const Judged& one) { return stands(one); })) {
      return Verdict::named;
    }
    return std::ranges::any_of(judged,
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
  [[nodiscard]] bool stands(const Judged& one) const {
    return one.others.empty() && !one.imitated_by &&
           probability_of(one.term, one.gain, data_) >= kNamed;
  }

  /// Whether it is likely, and nothing could be in its place.
  [[nodiscard]] bool is_doubtful(const Judged& one) const {
    return one.others.empty() && !one.imitated_by && !stands(one);
  }

  /// Effects that may be all that is wrong.
  struct Set {
    std::vector<std::string> ids;
    double probability = 1;

    [[nodiscard]] Set with(ForceTerm term, double times) const {
      Set more{ids, times * probability};
      more.ids.emplace_back(definition_of(term).id);
      return more;
    }
  };

  /// Each set with an effect or what could be in its place, and where it is doubtful without it.
  [[nodiscard]] std::vector<Set> with_each_of(const Judged& one,
                                              const std::vector<Set>& sets) const {
    double odds = 1;
    for (const Judged::Other& other : one.others) {
      odds += std::exp(-other.log_odds);
    }
    const double probability = probability_of(one.term, one.gain, data_) * one.share;
    std::vector<Set> all;
    for (const Set& set : sets) {
      all.push_back(set.with(one.term, probability / odds));
      for (const Judged::Other& other : one.others) {
        all.push_back(set.with(other.term, probability / odds * std::exp(-other.log_odds)));
      }
      if (probability < kNamed) {
        all.push_back({set.ids, set.probability * (1 - probability)});
      }
    }
    return all;
  }

  void add_candidates(Findings& findings) const {
    const bool nothing = findings.verdict == Verdict::none ||
                         (findings.verdict == Verdict::ambiguous && !remainder_.stands);
    const std::string rest = nothing ? "none" : "unknown";
    std::vector<Set> sets(1);
    for (const Judged& one : search_.judged()) {
      sets = with_each_of(one, sets);
    }
    double named = 0;
    for (const Set& set : sets) {
      if (set.ids.empty() || few()) {
        continue;
      }
      const double alone = remainder_.stands ? kOnlyCauses : 1;
      add_candidate(set.ids, alone * set.probability, findings.candidates);
      if (remainder_.stands) {
        Set beside = set;
        beside.ids.push_back(rest);
        add_candidate(std::move(beside.ids), (1 - alone) * set.probability, findings.candidates);
      }
      named += set.probability;
    }
    findings.candidates.push_back({rest, std::max(0.0, 1 - named)});
    std::ranges::stable_sort(findings.candidates, std::greater<>(), &Candidate::probability);
    findings.credible_set = credible_set_of(findings.candidates);
  }

  static void add_candidate(std::vector<std::string> ids, double probability,
                            std::vector<Candidate>& candidates) {
    std::ranges::sort(ids);
    const std::string id = fmt::format("{}", fmt::join(ids, "+"));
    const auto same = std::ranges::find(candidates, id, &Candidate::id);
    if (same == candidates.end()) {
      candidates.push_back({id, probability});
    } else {
      same->probability += probability;  // by another law
    }
  }

  /// A term with its parameters, but for its probability.
  /// @param half 95 % half-widths of the parameters of the model
  [[nodiscard]] FoundEffect effect_of(ForceTerm term, const ForceFit& model,
                                      std::span<const double> half) const {
    const ForceEffect& of = definition_of(term);
    FoundEffect found{.id = std::string(of.id),
                      .term = std::string(of.term),
                      .equation = std::string(of.equation),
                      .life_consequence = std::string(of.life_consequence),
                      .probability = 0,
                      .parameters = {}};
    std::size_t next = 2;
    for (const ForceTerm before : model.terms) {
      for (const ForceParameter& parameter : parameters_of(before, data_.scales())) {
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
    std::vector<double> half = search_.half_widths();
    for (double& width : half) {
      width *= remainder_.stands ? kBesideRemainder : 1;
    }
    for (const Judged& one : search_.judged()) {
      FoundEffect found = effect_of(one.term, search_.model().fit, half);
      found.probability = probability_of(one.term, one.gain, data_);
      if (!one.others.empty()) {
        std::vector<std::string> same{found.id};
        for (const Judged::Other& other : one.others) {
          same.emplace_back(definition_of(other.term).id);
        }
        findings.equivalent_sets.push_back(std::move(same));
      }
      if (findings.verdict != Verdict::named || stands(one)) {
        findings.effects.push_back(std::move(found));
      }
    }
  }

  /// Of the nominal model.
  [[nodiscard]] std::vector<SessionRefit> session_refits() const {
    const ForceFit& nominal = search_.nominal().fit;
    const std::vector<std::vector<double>> left_N = data_.residuals_N(nominal);
    std::vector<SessionRefit> refits;
    refits.reserve(left_N.size());
    for (std::size_t j = 0; j < left_N.size(); ++j) {
      const Eigen::Vector2d beside = data_.covariance().refit(j, vector_of(left_N[j])).value;
      refits.push_back({data_.records()[j].session, nominal.parameters[1] + beside(1),
                        -std::log(nominal.parameters[0]) - beside(0)});
    }
    return refits;
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
                .output_rmse_N = output_rmse_of({stairs_[i].fit, {}, std::nullopt}),
                .input_rmse_N = rmse_N,
                .log_predictive_density = density(stairs_[i].held.residuals_N),
                .sessions = static_cast<int>(data_.records().size())};
      if (i > 0) {
        const std::vector<double>& before_N2 = stairs_[i - 1].held.beside_scatter_N2;
        step.effect = effect_of(stairs_[i].fit.terms.back(), stairs_[i].fit,
                                data_.half_widths(stairs_[i].fit));
        step.effect.probability =
            probability_of(stairs_[i].fit.terms.back(),
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

  [[nodiscard]] HeldOutGain gain_of(const Extended& extended) const {
    const double before = search_.nominal_rmse_N();
    const double after = rmse_N(extended.held_N);
    HeldOutGain gain{
        .held_out_by = "session",
        .metrics = {{"rmse_N", output_rmse_of({search_.nominal().fit, {}, {}}),
                     output_rmse_of(extended)},
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
      const ForceRecord& record = data_.records()[j];
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
    extended_ = {by.fit, by.held.residuals_N, std::nullopt};
    if (findings.verdict != Verdict::none && !few()) {
      extended_ = corrected(std::move(extended_));
    }
    Extended written = extended_;
    for (std::size_t i = 0; i < written.fit.terms.size();) {
      if (is_writable(written.fit.terms[i])) {
        ++i;
      } else {
        written.fit = in_a_written_model(written.fit, i);
      }
    }
    if (written.fit.terms != extended_.fit.terms) {
      written.held_N = data_.held_out(written.fit).residuals_N;
      written = corrected(std::move(written));
    }
    for (std::size_t i = 0; i < written.fit.terms.size(); ++i) {
      findings.extensions.push_back(
          *written_term(written.fit.terms[i],
                        parameters_at(i, written.fit.terms, written.fit.parameters, data_.scales()),
                        data_.scales()));
    }
    add_refitted(written.fit, diagnosis);
    if (between && !findings.extensions.empty()) {
      findings.prose += either_way_prose(written.fit.terms);
    }
    if (written.correction) {
      findings.extensions.push_back(
          written_correction(*written.correction, written.fit.parameters[0]));
    }
    if (extended_.correction) {
      findings.gain = gain_of(extended_);
      findings.correction =
          Correction{.covariate = std::string(covariates_[extended_.correction->covariate].name),
                     .knots = extended_.correction->table.knots.size(),
                     .before_N = data_.rmse_N(by.held.plain_N2),
                     .after_N = rmse_N(extended_.held_N)};
      findings.prose += correction_prose(*findings.correction);
    }
    if (!findings.extensions.empty()) {
      diagnosis.damage_ratio = damage_ratio();
    }
  }

  /// With another law in the place of one that no model holds, of the same effect or of one that
  /// does as well; else without it.
  [[nodiscard]] ForceFit in_a_written_model(const ForceFit& model, std::size_t place) const {
    ForceFit without = data_.without(model, place);
    std::vector<ForceTerm> others;
    for (const ForceTerm law : kForceTerms) {
      if (same_effect(law, model.terms[place]) && is_shown(law, data_.records())) {
        others.push_back(law);
      }
    }
    const auto judged = std::ranges::find(search_.judged(), model.terms[place], &Judged::term);
    if (judged != search_.judged().end()) {
      for (const Judged::Other& other : judged->others) {
        others.push_back(other.term);
      }
    }
    std::erase(others, model.terms[place]);
    for (const ForceTerm other : others) {
      if (is_writable(other)) {
        return data_.with(without, other, 1);
      }
    }
    return without;
  }

  /// Its correction with it, where that gains on sessions that nothing was fitted to.
  [[nodiscard]] Extended corrected(Extended extended) const {
    extended.correction =
        correction_of(data_, extended.fit, extended.held_N, covariates_, rotor_known());
    if (extended.correction) {
      extended.held_N = extended.correction->held_N;
    }
    return extended;
  }

  /// A controller knows the position by its rotor alone.
  [[nodiscard]] bool rotor_known() const {
    return std::ranges::all_of(data_.records(), &ForceRecord::rotor_known);
  }

  /// Whether a model that is written can hold a term.
  [[nodiscard]] bool is_writable(ForceTerm term) const {
    return definition_of(term).written != nullptr && (term != ForceTerm::position || rotor_known());
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

  [[nodiscard]] double damage_ratio() const {
    double sum = 0;
    double sessions = 0;
    std::vector<double> before;
    std::vector<double> after;
    const ForceFit& nominal = search_.nominal().fit;
    for (std::size_t j = 0; j < data_.records().size(); ++j) {
      const ForceRecord& record = data_.records()[j];
      const Kinematics& kinematics = data_.kinematics()[j];
      predict_input(record, kinematics, nominal.terms, data_.scales(), nominal.parameters, before);
      predict_input(record, kinematics, extended_.fit.terms, data_.scales(),
                    extended_.fit.parameters, after);
      for (std::size_t i = 0; i < after.size(); ++i) {
        after[i] += added_N(extended_, j, i);
      }
      const double damage_before = damage_of(before, constants_);
      const double damage_after = damage_of(after, constants_);
      if (damage_before > 0 && damage_after > 0) {
        sum += std::log(damage_before / damage_after);
        sessions += 1;
      }
    }
    return sessions > 0 ? std::exp(sum / sessions) : 1;
  }

  /// What the correction adds at a sample.
  [[nodiscard]] double added_N(const Extended& extended, std::size_t record, std::size_t i) const {
    return extended.correction ? extended.correction->table.at_N(
                                     covariates_[extended.correction->covariate].values[record][i],
                                     data_.records()[record].velocity_m_s[i] < 0)
                               : 0;
  }

  [[nodiscard]] std::vector<std::vector<double>> left_N(const Extended& extended) const {
    std::vector<std::vector<double>> residuals_N = data_.residuals_N(extended.fit);
    for (std::size_t j = 0; j < residuals_N.size(); ++j) {
      for (std::size_t i = 0; i < residuals_N[j].size(); ++i) {
        residuals_N[j][i] -= data_.records()[j].used[i] ? added_N(extended, j, i) : 0;
      }
    }
    return residuals_N;
  }

  [[nodiscard]] double output_rmse_of(const Extended& extended) const {
    return output_rmse_N(data_, extended.fit, left_N(extended));
  }

  /// A model with what it leaves of the input force in each session.
  struct Left {
    explicit Left(const Report& report, const Extended& model)
        : parameters(model.fit.parameters), residuals_N(report.left_N(model)) {}

    [[nodiscard]] double squares_N2(std::size_t session) const {
      const std::vector<double>& of = residuals_N[session];
      return std::inner_product(of.begin(), of.end(), of.begin(), 0.0);
    }
    std::vector<double> parameters;
    std::vector<std::vector<double>> residuals_N;
  };

  /// The output force that each model has for the input of a session.
  [[nodiscard]] TracePicture trace_of(std::size_t session, const Left& before,
                                      const Left& after) const {
    const ForceRecord& record = data_.records()[session];
    const auto output_N = [&](const Left& model) {
      std::vector<double> all_N = record.output_N;
      for (std::size_t i = 0; i < all_N.size(); ++i) {
        all_N[i] += model.residuals_N[session][i] / model.parameters[0];
      }
      return all_N;
    };
    return {record.session,  record.time_s,    record.input_N,
            record.output_N, output_N(before), output_N(after)};
  }

  /// Of the first sessions.
  void add_traces(TensionDiagnosis& diagnosis) const {
    constexpr std::size_t kTraces = 4;
    const Left before(*this, {search_.nominal().fit, {}, std::nullopt});
    const Left after(*this, extended_);
    for (std::size_t j = 0; j < std::min(kTraces, data_.records().size()); ++j) {
      diagnosis.traces.push_back(trace_of(j, before, after));
    }
  }

  /// Of each cause that lessens the error, in the session where it does so most.
  void add_causes(TensionDiagnosis& diagnosis) const {
    std::optional<Left> before;
    for (std::size_t i = 0; i < stairs_.size(); ++i) {
      Left after(*this, {stairs_[i].fit, {}, std::nullopt});
      if (before) {
        std::vector<double> lessened_N2(data_.records().size());
        for (std::size_t j = 0; j < lessened_N2.size(); ++j) {
          lessened_N2[j] = before->squares_N2(j) - after.squares_N2(j);
        }
        if (std::accumulate(lessened_N2.begin(), lessened_N2.end(), 0.0) > 0) {
          const auto most =
              static_cast<std::size_t>(std::ranges::max_element(lessened_N2) - lessened_N2.begin());
          diagnosis.causes.push_back(
              {diagnosis.findings.steps[i].effect.id, trace_of(most, *before, after)});
        }
      }
      before = std::move(after);
    }
  }

  const ForceData& data_;
  const ForceSearch& search_;
  std::vector<ForceSearch::Candidate> stairs_;
  const NominalModel& nominal_;
  const reference::Constants& constants_;
  const std::vector<ForceCovariate>& covariates_;
  ForceRemainder remainder_;
  Extended extended_;
};

}  // namespace

TensionDiagnosis diagnose_forces(const std::vector<ForceRecord>& records,
                                 const NominalModel& nominal, const reference::Constants& constants,
                                 const DiagnoseOptions& options) {
  ForceData data(records);
  ForceSearch search(data, records, nominal.sheath ? nominal.sheath->friction_coefficient : 0.1,
                     options);
  search.run();
  return Report(data, search, nominal, constants, options.seed).diagnosis();
}

}  // namespace host_sim::diagnose
