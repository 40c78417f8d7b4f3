#include "host_sim/diagnose/lives/prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "host_sim/diagnose/lives/terms.hpp"
#include "host_sim/statistics/common_shape.hpp"

namespace host_sim::diagnose::lives {
namespace {

bool is_effect(std::string_view id) {
  return std::ranges::any_of(effects::life_effects(),
                             [&](const auto& effect) { return effect->id() == id; });
}

/// Effects that take part in any candidate of a set, in order of their ids.
std::set<std::string> effects_of(const std::vector<std::string>& set) {
  std::set<std::string> ids;
  for (const std::string& candidate : set) {
    for (const std::string_view id : effects_in(candidate)) {
      if (is_effect(id)) {
        ids.emplace(id);
      }
    }
  }
  return ids;
}

std::string most_significant(const Omnibus& omnibus) {
  const auto least = std::ranges::min_element(
      omnibus.tests,
      [](const CovariateTest& one, const CovariateTest& other) { return one.p < other.p; });
  return least == omnibus.tests.end() ? "" : least->covariate;
}

std::string named_prose(const Findings& findings) {
  std::string prose;
  for (const FoundEffect& effect : findings.effects) {
    prose += fmt::format("{}{} ({}, probability {:.3f})", prose.empty() ? "" : " and ", effect.id,
                         effect.term, effect.probability);
  }
  return prose;
}

/// Twice a difference of log likelihoods: the 0.99 point of chi-square with one degree of freedom.
constexpr double kRejected = 6.634896601021214;

constexpr std::uint64_t kShapeStream = 502;
constexpr std::size_t kLeastFailures = 5;

struct Levels {
  std::vector<statistics::Sample> samples;
  std::vector<double> tensions_N;
};

Levels levels_with_failures(const Campaign& campaign) {
  Levels levels;
  for (const Level& level : levels_of(campaign)) {
    statistics::Sample sample;
    std::size_t failures = 0;
    for (const Campaign::Specimen* specimen : level.specimens) {
      const bool failed = specimen->status == Campaign::Status::failed;
      sample.push_back({specimen->cycles(), failed});
      failures += failed ? 1 : 0;
    }
    if (level.role == Campaign::Role::fit && failures >= kLeastFailures) {
      levels.samples.push_back(std::move(sample));
      levels.tensions_N.push_back(level.load.effective_tension_N);
    }
  }
  return levels;
}

}  // namespace

std::string experiment_for(const std::vector<std::string>& credible_set) {
  const std::set<std::string> ids = effects_of(credible_set);
  std::set<std::string> experiments;
  for (const std::string& id : ids) {
    for (const effects::Separation& separation : life_effect(id).separations()) {
      if (ids.size() == 1 || ids.contains(std::string(separation.other))) {
        experiments.insert(std::string(separation.experiment));
      }
    }
  }
  if (experiments.empty() && !ids.empty()) {
    experiments.insert(
        "cross levels of T_eff with mean tension, bend ratio, lots and storage, and "
        "test more specimens at each");
  }
  return fmt::format("{}", fmt::join(experiments, "; "));
}

std::string verdict_prose(const Findings& findings, const Omnibus& before, const Omnibus& after) {
  switch (findings.verdict) {
    case Verdict::none:
      return fmt::format(
          "The lives show no discrepancy from the nominal law (p = {:.2g} for the largest "
          "residual).",
          before.p);
    case Verdict::named:
      return fmt::format(
          "The nominal law is wrong (p = {:.2g}); {} explains it, and no discrepancy remains (p = "
          "{:.2g}).",
          before.p, named_prose(findings), after.p);
    case Verdict::ambiguous:
      return fmt::format(
          "Something may be wrong with the nominal law (p = {:.2g}, most against {}), and these "
          "lives do not determine what: {} have a probability of 95 % together.",
          before.p, most_significant(before), fmt::join(findings.credible_set, ", "));
    case Verdict::unknown:
      break;
  }
  if (!after.tests.empty()) {
    return fmt::format(
        "The nominal law is wrong (p = {:.2g}), and with the best effect of the catalogue a "
        "discrepancy remains against {} (p = {:.2g}).",
        before.p, most_significant(after), after.p);
  }
  return fmt::format(
      "The nominal law is wrong (p = {:.2g}, most against {}) in a way that no effect of the "
      "catalogue explains.",
      before.p, most_significant(before));
}

std::string mean_stress_prose(const std::vector<Hypothesis>& hypotheses, const Hypothesis& best) {
  std::vector<std::string> others = best.effects;
  if (best.outside || std::erase(others, "mean_stress") == 0) {
    return "";
  }
  const auto gerber = std::ranges::find_if(hypotheses, [&](const Hypothesis& hypothesis) {
    return !hypothesis.outside && hypothesis.effects == others;
  });
  if (gerber == hypotheses.end()) {
    return "";
  }
  std::string gains;
  std::set<std::string> laws;
  for (const Hypothesis::Form& form : best.forms) {
    const auto law = std::ranges::find(form.model, "mean_stress", &Term::id);
    if (laws.insert(law->law).second) {
      gains += fmt::format(
          "{}{:.1f} {} with {}'s", gains.empty() ? "" : " and ",
          2 * std::abs(form.fit.log_likelihood - gerber->best().fit.log_likelihood),
          form.fit.log_likelihood > gerber->best().fit.log_likelihood ? "larger" : "smaller",
          law->law);
    }
  }
  const double gain = 2 * (best.best().fit.log_likelihood - gerber->best().fit.log_likelihood);
  return fmt::format(" Against Gerber's law of mean stress{} twice the log likelihood is {}.",
                     gain > kRejected ? ", which is rejected," : "", gains);
}

std::string shape_prose(const Campaign& campaign, const ShapeTestOptions& options) {
  const Levels levels = levels_with_failures(campaign);
  constexpr std::size_t kLeastLevels = 3;
  if (levels.samples.size() < kLeastLevels) {
    return "";
  }
  const statistics::BootstrapOptions bootstrap{
      .seed = options.seed, .stream = kShapeStream, .replicates = 2000, .threads = options.threads};
  const std::vector<statistics::Test> tests =
      statistics::test_shapes(levels.samples, bootstrap).one_against_rest;
  std::size_t odd = 0;
  statistics::Test least{.p_simulated = 2};
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (tests[i].p_simulated < least.p_simulated) {
      least = tests[i];
      odd = i;
    }
  }
  constexpr double kDiffers_p = 0.05;
  if (!(least.p_simulated * static_cast<double>(levels.samples.size()) < kDiffers_p)) {
    return "";
  }
  std::vector<statistics::Sample> rest = levels.samples;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(odd));
  return fmt::format(
      "The lives at {:.1f} N have a Weibull shape of {:.2f} against {:.2f} of the other levels "
      "(p = {:.1g} by the likelihood ratio, {:.1g} simulated), as another mode of failure would.",
      levels.tensions_N[odd],
      statistics::fit(statistics::Family::weibull, levels.samples[odd]).distribution.second,
      statistics::fit_common_shape(rest).shape, least.p_chi_square, least.p_simulated);
}

}  // namespace host_sim::diagnose::lives
