#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/audit.hpp"
#include "host_sim/diagnose/lives/decision.hpp"
#include "host_sim/diagnose/lives/discrepancy.hpp"
#include "host_sim/diagnose/lives/estimates.hpp"
#include "host_sim/diagnose/lives/fit.hpp"
#include "host_sim/diagnose/lives/gain_test.hpp"
#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/likelihood.hpp"
#include "host_sim/diagnose/lives/prose.hpp"
#include "host_sim/diagnose/lives/validation.hpp"
#include "host_sim/effects/life_effect.hpp"

namespace host_sim::diagnose {
namespace lives {
namespace {

/// Of equal damage: the power mean of the blocks.
double equivalent_N(const LifeSample::Specimen& specimen, double exponent) {
  double powers = 0;
  for (const LifeSample::Block& block : specimen.blocks) {
    powers += block.cycles * std::pow(block.effective_N, exponent);
  }
  return std::pow(powers / specimen.cycles(), 1 / exponent);
}

/// Each life over alpha of the model, cox_snell^(1/beta), under the nominal law and the extended
/// one.
LifePicture picture_of(const LifeSample& sample, const LifeSettings& before,
                       const LifeSettings& after) {
  const std::vector<Residual> residuals_before = residuals_of(sample, before);
  const std::vector<Residual> residuals_after = residuals_of(sample, after);
  LifePicture picture{.points = {}, .shape_before = before.shape, .shape_after = after.shape};
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const LifeSample::Specimen& specimen = sample.specimens[i];
    picture.points.push_back(
        {.specimen = specimen.name,
         .lot = specimen.lot,
         .effective_N = equivalent_N(specimen, before.exponent),
         .ratio_before = std::pow(residuals_before[i].cox_snell, 1 / before.shape),
         .ratio_after = std::pow(residuals_after[i].cox_snell, 1 / after.shape),
         .failed = specimen.failed});
  }
  return picture;
}

/// Why the nominal law cannot be fitted to these lives, so that nothing can be asked of them; empty
/// where it can.
std::string hindrance(const LifeSample& sample, const NominalFit& nominal) {
  constexpr std::size_t kLeastToJudge = 6;
  if (sample.failures() < kLeastToJudge) {
    return fmt::format("{} of {} specimens failed; {} failures are the least to judge a law by",
                       sample.failures(), sample.size(), kLeastToJudge);
  }
  if (sample.levels < 2 && !sample.nominal) {
    return "all specimens were tested at one effective tension, which says nothing of gamma; give "
           "the campaign a [model.life], or test at three levels or more";
  }
  switch (nominal.problem) {
    case statistics::FitProblem::none:
      return "";
    case statistics::FitProblem::too_few_failures:
      return "fewer than two specimens failed";
    case statistics::FitProblem::no_spread:
      return "all failures lie on the law without any scatter, which no lives do";
    case statistics::FitProblem::not_identified:
      return "failures at one effective tension alone say nothing of gamma; test at three levels "
             "or "
             "more";
    case statistics::FitProblem::not_converged:
      break;
  }
  return "the nominal law could not be fitted to these lives";
}

/// All that can be said then: nothing is named, each effect is invisible.
LifeDiagnosis undiagnosed(const Campaign& campaign, const std::string& why) {
  LifeDiagnosis diagnosis;
  Findings& findings = diagnosis.findings;
  findings.prose = "These lives cannot be diagnosed.";
  findings.next_experiment = why;
  findings.doubts = {{{}, "", why, true}};
  findings.candidates = {{"none", 1}, {"unknown", 0}};
  findings.credible_set = {"none"};
  for (const auto& effect : effects::life_effects()) {
    findings.invisible.push_back({std::string(effect->id()), why});
  }
  if (campaign.nominal.life) {
    diagnosis.ipl_scale = campaign.nominal.life->ipl_scale;
    diagnosis.ipl_exponent = campaign.nominal.life->ipl_exponent;
    diagnosis.weibull_shape = campaign.nominal.life->weibull_shape;
  }
  return diagnosis;
}

/// No wire is thicker than what it bends around.
std::optional<Doubt> doubt_of_ratios(const Campaign& campaign) {
  const auto inverse = std::ranges::count_if(
      campaign.specimens,
      [](const Campaign::Specimen& specimen) { return specimen.wire_to_bend_ratio > 1.0; });
  if (inverse == 0) {
    return std::nullopt;
  }
  return Doubt{{},
               "wire_to_bend_ratio",
               fmt::format("of {} specimens the wire would be thicker than what it bends around: "
                           "is the ratio D/d in place of d/D?",
                           inverse),
               false};
}

/// Structure that is left with less than this by chance is not explained.
constexpr double kLeft_p = 0.003;

class Diagnostician {
 public:
  Diagnostician(const Campaign& campaign, const DiagnoseOptions& options, LifeSample sample)
      : campaign_(campaign),
        options_(options),
        sample_(std::move(sample)),
        prior_(common_prior(sample_)) {}

  LifeDiagnosis run(const NominalFit& nominal) {
    const std::vector<std::string> visible = audit(nominal);
    report(0.1);
    before_ = omnibus_test(sample_, omnibus_options());
    report(0.2);
    hypotheses_ = weigh(sample_, visible, calibration(), options_.threads);
    nominal_ = fit_model(ModelView(sample_, prior_, {}));
    decision_ = decide(hypotheses_, before_.p);
    report(0.6);
    ask_the_gain();
    report(0.7);
    check_what_is_left();
    write_findings();
    write_model();
    return std::move(diagnosis_);
  }

 private:
  void report(double share) const {
    if (options_.progress) {
      options_.progress(share);
    }
  }

  [[nodiscard]] OmnibusOptions omnibus_options() const {
    return {.seed = options_.seed, .threads = options_.threads};
  }

  std::vector<std::string> audit(const NominalFit& nominal) {
    std::vector<Campaign::Specimen> fitted;
    std::ranges::copy_if(
        campaign_.specimens, std::back_inserter(fitted),
        [](const Campaign::Specimen& specimen) { return specimen.role == Campaign::Role::fit; });
    const LifeAudit audit = audit_lives(sample_, fitted, nominal, options_.without);
    for (const LifeEffectAudit& effect : audit.effects) {
      if (!effect.visible()) {
        diagnosis_.findings.invisible.push_back({std::string(effect.effect->id()), effect.why});
      }
    }
    diagnosis_.findings.equivalent_sets = audit.equivalent;
    return audit.visible();
  }

  [[nodiscard]] const Hypothesis::Form& extended() const { return decision_.best->best(); }

  /// What is probable and shows against no covariate is named where lives of the nominal law seldom
  /// gain as much by it.
  void ask_the_gain() {
    constexpr double kSeldom_p = 0.05;
    if (decision_.verdict != Verdict::ambiguous || decision_.best == nullptr ||
        decide(hypotheses_, 0).verdict != Verdict::named) {
      return;
    }
    const Decision named = decide(hypotheses_, 0);
    const Hypothesis::Form& form = named.best->best();
    gain_p_ = gain_p(sample_, prior_, form.model, nominal_, form.fit,
                     {.seed = options_.seed, .threads = options_.threads});
    if (*gain_p_ <= kSeldom_p) {
      decision_ = named;
    }
  }

  /// Named effects must leave no discrepancy; nor may there be one where nothing is wrong.
  void check_what_is_left() {
    double doubt = 1;
    if (decision_.verdict == Verdict::named && decision_.best != nullptr) {
      const ModelView view(sample_, prior_, extended().model);
      std::vector<double> cox_snell;
      for (const Residual& residual : residuals_of(sample_, view.settings(extended().fit.at))) {
        cox_snell.push_back(residual.cox_snell);
      }
      after_ = omnibus_test(without_effects(sample_, cox_snell), omnibus_options());
      doubt = after_.p < kLeft_p ? 0.04 : 1;
    } else if (decision_.verdict == Verdict::none) {
      doubt = before_.p < kLeft_p ? 0.4 : 1;
    }
    if (doubt < 1) {
      raise_unknown(doubt);
    }
  }

  /// What is not unknown keeps this share of its probability.
  void raise_unknown(double kept) {
    for (Candidate& candidate : decision_.candidates) {
      candidate.probability *= kept;
      if (candidate.id == "unknown") {
        candidate.probability += 1 - kept;
      }
    }
    std::ranges::stable_sort(decision_.candidates, [](const Candidate& one, const auto& other) {
      return one.probability > other.probability;
    });
    decision_.credible_set = credible_set_of(decision_.candidates);
    decision_.verdict = Verdict::unknown;
    decision_.effects.clear();
    decision_.probabilities.clear();
  }

  void write_findings() {
    Findings& findings = diagnosis_.findings;
    findings.verdict = decision_.verdict;
    findings.candidates = decision_.candidates;
    findings.credible_set = decision_.credible_set;
    write_discrepancies();
    if (!decision_.effects.empty()) {
      write_effects();
    }
    if (findings.verdict == Verdict::named) {
      findings.gain = gain_of(sample_, extended().model, extended().fit, options_.threads);
      if (withdraw_unless_improved(findings)) {
        findings.refitted.clear();  // beside the extension
      }
    }
    report(0.9);
    if (findings.verdict == Verdict::ambiguous) {
      findings.next_experiment = experiment_for(findings.credible_set);
    }
    Omnibus before = before_;
    before.p = gain_p_.value_or(before_.p);
    findings.prose = verdict_prose(findings, before, after_) + no_gain_prose(findings);
    if (sample_.levels == 1) {
      findings.prose += " All lives are at one effective tension: gamma is that of the model.";
    }
    if (gain_p_) {
      findings.prose += fmt::format(
          " No covariate alone shows it (p = {:.2g}): lives of the nominal law gain as much by the "
          "most probable model with p = {:.2g}.",
          before_.p, *gain_p_);
    }
    if (decision_.best != nullptr) {
      findings.prose += mean_stress_prose(hypotheses_, *decision_.best);
    }
    const std::string validation =
        validation_prose(campaign_, ModelView(sample_, prior_, {}), nominal_);
    findings.prose += validation.empty() ? "" : " " + validation;
    const std::string shape = shape_prose(campaign_, {options_.seed, options_.threads});
    findings.prose += shape.empty() ? "" : " " + shape;
  }

  void write_discrepancies() {
    for (std::size_t i = 0; i < before_.tests.size(); ++i) {
      const CovariateTest& test = before_.tests[i];
      const auto same = std::ranges::find(after_.tests, test.covariate, &CovariateTest::covariate);
      diagnosis_.findings.discrepancies.push_back(
          {.covariate = test.covariate,
           .statistic = test.statistic,
           .p = test.p,
           .p_after = same == after_.tests.end() ? test.p : same->p});
    }
  }

  void write_effects() {
    const ModelView view(sample_, prior_, extended().model);
    const ModelEstimates estimates = estimates_of(view, extended().fit, options_.threads);
    for (std::size_t i = 0; i < decision_.effects.size(); ++i) {
      const effects::LifeEffect& effect = life_effect(decision_.effects[i]);
      diagnosis_.findings.effects.push_back(
          {.id = decision_.effects[i],
           .term = extended().model[i].words.empty() ? std::string(effect.term())
                                                     : extended().model[i].words,
           .equation = std::string(effect.equation()),
           .life_consequence = std::string(effect.life_consequence()),
           .probability = decision_.probabilities[i],
           .parameters = estimates.terms[i]});
    }
    diagnosis_.findings.refitted = estimates.refitted;
    if (decision_.verdict == Verdict::named) {
      write_extensions(view);
    }
  }

  void write_extensions(const ModelView& view) {
    const LifeSettings settings = view.settings(extended().fit.at);
    for (std::size_t i = 0; i < extended().model.size(); ++i) {
      const Term& term = extended().model[i];
      const std::vector<double> fitted = view.values(extended().fit.at, i);
      const std::vector<double> values =
          term.of_catalogue ? term.of_catalogue(fitted, settings) : fitted;
      Extension extension{.id = term.id, .values = {}};
      const auto parameters = life_effect(term.id).parameters();
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        extension.values.push_back({std::string(parameters[k].name), {values[k]}});
      }
      std::ranges::copy(term.companions, std::back_inserter(extension.values));
      diagnosis_.findings.extensions.push_back(std::move(extension));
    }
  }

  [[nodiscard]] LifeSettings settings_after() const {
    if (diagnosis_.findings.verdict != Verdict::named) {
      return ModelView(sample_, prior_, {}).settings(nominal_.at);
    }
    return ModelView(sample_, prior_, extended().model).settings(extended().fit.at);
  }

  void write_model() {
    const ModelView nominal(sample_, prior_, {});
    const LifeSettings before = nominal.settings(nominal_.at);
    const LifeSettings after = settings_after();
    diagnosis_.picture = picture_of(sample_, before, after);
    if (diagnosis_.findings.refitted.empty()) {
      diagnosis_.findings.refitted = estimates_of(nominal, nominal_, options_.threads).refitted;
    }
    diagnosis_.ipl_scale = diagnosis_.findings.refitted[0].value;
    diagnosis_.ipl_exponent = after.exponent;
    diagnosis_.weibull_shape = after.shape;
    constexpr double kB10 = 0.1;
    const auto lowest =
        std::ranges::min_element(sample_.specimens, [](const auto& one, const auto& other) {
          return one.last().effective_N < other.last().effective_N;
        });
    LifeSample::Specimen specimen = *lowest;
    specimen.blocks = {specimen.last()};
    specimen.order = LifeSample::Order::constant;
    diagnosis_.b10_ratio = quantile_cycles(sample_, specimen, before, kB10) /
                           quantile_cycles(sample_, specimen, after, kB10);
    report(1);
  }

  const Campaign& campaign_;
  const DiagnoseOptions& options_;
  LifeSample sample_;
  CommonPrior prior_;
  Omnibus before_, after_;
  std::optional<double> gain_p_;  ///< where no covariate shows the gain
  std::vector<Hypothesis> hypotheses_;
  ModelFit nominal_;
  Decision decision_;
  LifeDiagnosis diagnosis_;
};

}  // namespace
}  // namespace lives

LifeDiagnosis diagnose_lives(const Campaign& campaign, const DiagnoseOptions& options) {
  lives::LifeSample sample = lives::sample_of(campaign, Campaign::Role::fit);
  lives::NominalFit nominal;
  if (sample.failures() > 0) {
    nominal = lives::fit_nominal(sample);
  }
  const std::string why = lives::hindrance(sample, nominal);
  LifeDiagnosis diagnosis =
      why.empty() ? lives::Diagnostician(campaign, options, std::move(sample)).run(nominal)
                  : lives::undiagnosed(campaign, why);
  if (const auto doubt = lives::doubt_of_ratios(campaign)) {
    diagnosis.findings.doubts.push_back(*doubt);
  }
  return diagnosis;
}

}  // namespace host_sim::diagnose
