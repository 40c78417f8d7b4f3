#pragma once

#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/report/page/chart.hpp"
#include "host_sim/report/page/stretch.hpp"

/// The plots of the page of a diagnosis. What the nominal model says and what the extended one says
/// have the same colours everywhere. A chart without anything to show has no layers.
namespace host_sim::diagnose_page {

/// How the nominal and the extended model look.
inline constexpr std::string_view kBeforeColour = "mark";
inline constexpr std::string_view kAfterColour = "line";

/// The sessions whose output tension the nominal model misses most, as indices into the traces, the
/// largest error first; at most `most`.
[[nodiscard]] std::vector<std::size_t> worst_traces(const diagnose::TensionDiagnosis& tension,
                                                    std::size_t most);

/// Root of the mean square of the difference, in N; NaN where there is nothing to compare.
[[nodiscard]] double rmse_N(const std::vector<double>& measured_N,
                            const std::vector<double>& simulated_N);

/// Output tension of one session over time, measured and simulated.
[[nodiscard]] Chart trace_chart(const diagnose::TensionDiagnosis& tension, std::size_t trace);

/// Its loop in one or two cycles: output tension over input tension, with the direction of travel.
[[nodiscard]] Chart loop_chart(const diagnose::TensionDiagnosis& tension, std::size_t trace);

/// The loop of what one cause does, without and with it, in the session where it shows most.
[[nodiscard]] Chart cause_chart(const diagnose::TensionDiagnosis& tension, std::size_t cause);

/// What both models leave of the input force against the covariate that it shows most against, in
/// one direction, with the scatter of sessions.
[[nodiscard]] Chart remainder_chart(const diagnose::TensionDiagnosis& tension, std::size_t index);

enum class SessionParameter { friction, gain };

/// What the nominal model gives for each session alone: a point each, by name.
[[nodiscard]] Chart session_chart(const diagnose::TensionDiagnosis& tension,
                                  SessionParameter parameter);

/// Errors held out as a staircase, a tread for each of Findings::steps.
[[nodiscard]] Chart steps_chart(const diagnose::Findings& findings);

/// The same from the nominal to the extended model, of the errors of tensions among the metrics.
[[nodiscard]] Chart gain_chart(const diagnose::HeldOutGain& gain);

/// Weibull plot of the lives over the predicted ones; the lines are what the models say.
[[nodiscard]] Chart weibull_chart(const diagnose::LifeDiagnosis& lives);

enum class Model { nominal, extended };

/// The lives over the predicted ones by effective tension, lot by lot where they are few. Of the
/// extended model there is nothing to show where nothing was extended.
[[nodiscard]] Chart ratio_chart(const diagnose::LifeDiagnosis& lives, Model model);

/// How many sessions are drawn.
inline constexpr std::size_t kMostTraces = 4;

/// All of the above that the page shows and that have something to show, in its order.
[[nodiscard]] std::vector<Chart> charts(const diagnose::Diagnosis& diagnosis);

}  // namespace host_sim::diagnose_page
