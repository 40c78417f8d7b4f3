#include "host_sim/diagnose/force/prose.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {
namespace {

std::string what_is_left(const Remainder& remainder) {
  constexpr double kLeastP = 0.001;
  return fmt::format("What is left shows most against {} ({}).", remainder.covariate,
                     remainder.p < kLeastP ? fmt::format("p below {}", kLeastP)
                                           : fmt::format("p {:.2g}", remainder.p));
}

}  // namespace

std::string listed(const std::vector<FoundEffect>& effects) {
  constexpr double kPercent = 100;
  std::vector<std::string> terms;
  terms.reserve(effects.size());
  for (const FoundEffect& effect : effects) {
    terms.push_back(
        fmt::format("{} ({}, {:.1f} %)", effect.term, effect.id, kPercent * effect.probability));
  }
  return listed(terms, "and");
}

std::string how_far(const std::vector<Step>& steps) {
  if (steps.size() < 2) {
    return "";
  }
  std::vector<std::string> effects;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    effects.push_back(fmt::format("{} ({})", steps[i].effect.term, steps[i].effect.id));
  }
  return fmt::format(
      " On sessions held out, Capstan friction alone has an error of {:.3g} N of output and {:.3g} "
      "N of input tension; with {} that is {:.3g} N and {:.3g} N.",
      steps.front().output_rmse_N, steps.front().input_rmse_N, listed(effects, "and"),
      steps.back().output_rmse_N, steps.back().input_rmse_N);
}

std::string verdict_prose(const Findings& findings, std::size_t sessions, double nominal_rmse_N,
                          bool spoilt) {
  const Remainder& left = findings.remainder.value();
  if (spoilt) {
    return "The recordings cannot be right as they are: nothing is named before the doubts below "
           "are settled.";
  }
  const std::string few = sessions < kLeastSessions
                              ? fmt::format(" It takes {1} sessions to name anything (here: {0}).",
                                            sessions, kLeastSessions)
                              : "";
  if (findings.verdict == Verdict::none) {
    return fmt::format(
               "Nothing in {} recordings disagrees with the model beyond noise and the scatter of "
               "sessions.{}",
               sessions, findings.doubts.empty() ? "" : " Beside that stand the doubts below.") +
           few;
  }
  if (findings.effects.empty()) {
    return "The recordings contain structure that no effect of the catalogue explains. " +
           what_is_left(left) + how_far(findings.steps) + few;
  }
  const bool many = findings.effects.size() > 1;
  std::string text = fmt::format(
      "The recordings disagree with the model, and {} {}. With {} the error of the input tension "
      "on sessions that the fit never saw is {:.3g} N in place of {:.3g} N. {}",
      findings.verdict != Verdict::named ? "what may be the cause is"
      : many                             ? "the causes are"
                                         : "the cause is",
      listed(findings.effects), many ? "them" : "it", left.input_rmse_N, nominal_rmse_N,
      what_is_left(left));
  for (const Candidate& candidate : findings.candidates) {
    constexpr double kLeastOfNone = 0.05;
    if (candidate.id == "none" && candidate.probability >= kLeastOfNone) {
      constexpr double kPercent = 100;
      text += fmt::format(" That nothing is wrong has a probability of {:.0f} %.",
                          kPercent * candidate.probability);
    }
  }
  for (const auto& same : findings.equivalent_sets) {
    text += fmt::format(" In place of {} it may be {}.", same.front(),
                        fmt::join(same.begin() + 1, same.end(), " or "));
  }
  return text;
}

std::string imitation_prose(const effects::ForceLaw& effect, const effects::ForceLaw& outside) {
  return fmt::format(
      " What looks like {} ({}) may as well be {}, {}, which the catalogue does not have.",
      effect.term(), effect.id(), outside.term(), outside.equation);
}

std::string doubtful_prose(const effects::ForceLaw& effect, double probability) {
  constexpr double kPercent = 100;
  return fmt::format(" There may be {} ({}) besides, with a probability of {:.0f} %.",
                     effect.term(), effect.id(), kPercent * probability);
}

std::string either_way_prose(const effects::ForceTerms& written) {
  std::vector<std::string> terms;
  terms.reserve(written.size());
  for (const effects::ForceTerm term : written) {
    terms.emplace_back(law_of(term).term());
  }
  return fmt::format(
      " A model that is written holds {}, by which it predicts as well as by others.",
      listed(terms, "and"));
}

std::string not_written_prose(const std::vector<std::string>& terms, bool corrected,
                              double rmse_N) {
  return fmt::format(
      " A model that is written cannot hold {}, which no controller evaluates or no table has room "
      "for; {} its error of the input tension is {:.3g} N.",
      listed(terms, "and"), corrected ? "with a correction in its place" : "without it", rmse_N);
}

std::string correction_prose(const Correction& correction) {
  return fmt::format(
      " What is left repeats in sessions that nothing was fitted to: a correction over {} by "
      "direction, which is no cause, takes the error of the input force on them from {:.3g} N to "
      "{:.3g} N.",
      correction.covariate, correction.before_N, correction.after_N);
}

}  // namespace host_sim::diagnose
