#include "host_sim/report/diagnose/captions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host_sim/report/diagnose/charts.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::diagnose_page::captions {

std::string traces(const diagnose::TensionDiagnosis& tension) {
  const std::size_t shown = worst_traces(tension, kMostTraces).size();
  const std::string which =
      shown < tension.traces.size()
          ? fmt::format(
                "The {} of {} sessions that the nominal model misses most, worst first. "
                "The nominal model has its parameters refitted.",
                shown, tension.traces.size())
          : "The nominal model has its parameters refitted. The session that it misses most "
            "comes first.";
  return which +
         " Loops are of one or two cycles from the middle of the recording, with arrows as time "
         "goes on. The width of a loop is the friction. Where loops differ, and whether at "
         "reversals, at high or at low tension, indicates the cause.";
}

std::string trace(const diagnose::TensionDiagnosis& tension, std::size_t index) {
  const diagnose::TracePicture& trace = tension.traces.at(index);
  std::string text = fmt::format("The error of the nominal model is {} (RMSE)",
                                 quantity_text(rmse_N(trace.measured_N, trace.before_N), "N"));
  if (!tension.findings.extensions.empty()) {
    text += fmt::format(", that of the extended one {}",
                        quantity_text(rmse_N(trace.measured_N, trace.after_N), "N"));
  }
  text += ".";
  const std::size_t gaps = gaps_in(trace.time_s).size();
  return gaps == 0 ? text : text + fmt::format(" {} of it, left open.", counted_text(gaps, "gap"));
}

namespace {

/// "From 2 s to 4 s." of the cycles that are drawn; empty without any.
std::string when(const diagnose::TracePicture& trace) {
  const Stretch stretch = cycles_in(trace.input_N);
  if (stretch.last <= stretch.first || trace.time_s.size() < stretch.last) {
    return {};
  }
  return fmt::format("From {} to {}.", quantity_text(trace.time_s[stretch.first], "s"),
                     quantity_text(trace.time_s[stretch.last - 1], "s"));
}

}  // namespace

std::string loop(const diagnose::TensionDiagnosis& tension, std::size_t index) {
  return when(tension.traces.at(index));
}

std::string causes() {
  return "What each cause does: the loop that the model has without it and with it, beside the "
         "causes before it, in the session whose error it lessens most.";
}

std::string cause(const diagnose::TensionDiagnosis& tension, std::size_t index) {
  const diagnose::TracePicture& trace = tension.causes.at(index).trace;
  return fmt::format("{} The error of the whole session is {} (RMSE) without it, {} with it.",
                     when(trace), quantity_text(rmse_N(trace.measured_N, trace.before_N), "N"),
                     quantity_text(rmse_N(trace.measured_N, trace.after_N), "N"));
}

std::string remainders() {
  return "What the models leave of the input tension, in bins of the covariates that it shows most "
         "against: means of the sessions, with bars of one standard deviation between sessions. "
         "Means that are far from zero in the same direction in all sessions are structure that "
         "the model lacks.";
}

std::string remainder(const diagnose::TensionDiagnosis& tension, std::size_t index) {
  const diagnose::RemainderPicture& remainder = tension.remainders.at(index);
  const auto largest = [](const std::vector<double>& means_N) {
    double most_N = 0;
    for (const double mean_N : means_N) {
      most_N = std::max(most_N, std::abs(mean_N));
    }
    return quantity_text(most_N, "N");
  };
  return remainder.after_N == remainder.before_N
             ? fmt::format("The largest mean is {}.", largest(remainder.before_N))
             : fmt::format("The largest mean is {} with the nominal model, {} with the other.",
                           largest(remainder.before_N), largest(remainder.after_N));
}

std::string sessions() {
  return "What the nominal model gives where it is fitted to one session alone. Sessions that "
         "differ by more than they scatter, or that drift, are evidence against one model for all.";
}

std::string weibull(const diagnose::LifeDiagnosis& lives) {
  std::string text = fmt::format(
      "Each failure at its life over what the model predicts and at its median rank. A model that "
      "holds has its points along its line. Shape of the residual lives: {} with the nominal model",
      number_text(lives.picture.shape_before));
  if (!lives.findings.extensions.empty()) {
    text += fmt::format(", {} with the extended one", number_text(lives.picture.shape_after));
  }
  return text + ".";
}

std::string ratio_before() {
  return "Lives that drift with the tension, or lots that stand apart, are evidence against the "
         "model.";
}

std::string ratio_after() {
  return "What the drift and the lots are once the model is extended.";
}

std::string ranking(const diagnose::Findings& findings) {
  const std::size_t credible = findings.credible_set.size();
  if (credible == 0) {
    return "All probabilities sum to 1.";
  }
  const std::string_view prose = credible == 1
                                     ? "The candidate in full colour holds 95\u00a0% alone"
                                     : "Those in full colour hold 95\u00a0% together";
  return fmt::format(
      "All probabilities sum to 1. {}. The probability of an effect is the sum over all candidates "
      "that hold it; it is named from {} on.",
      prose, percent_text(diagnose::kNamed));
}

std::string discrepancies() {
  return "The largest deviation over each covariate against what noise and the scatter of sessions "
         "or specimens give. A small p says that something is wrong; after the extension it should "
         "be large.";
}

std::string steps(const diagnose::Findings& findings) {
  const std::string text =
      "As far as the catalogue goes: the nominal model, then one effect more in each row, each "
      "the one that the recordings speak for most. The errors are of sessions that the fit "
      "never saw, of each tension from the other. The probabilities are those that the effects "
      "would have if the catalogue held all that there is, which it does not";
  return text + (findings.effects.empty() ? ": nothing is named." : ".");
}

std::string steps_chart() {
  return "How far down each effect of the catalogue brings the error on sessions that the fit "
         "never "
         "saw.";
}

std::string gain_chart() {
  return "How far down the extension brings the error on data that the fit did not use.";
}

std::string gain(const diagnose::HeldOutGain& gain) {
  return gain.held_out_by.empty()
             ? std::string("On data that the fit did not use.")
             : fmt::format("On data that the fit did not use, held out by {}.", gain.held_out_by);
}

}  // namespace host_sim::diagnose_page::captions
