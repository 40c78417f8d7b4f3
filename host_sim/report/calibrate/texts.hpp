#pragma once

#include <string>

#include "host_sim/calibrate/result.hpp"

/// Numbers of a calibration in words: plain text, not yet escaped.
namespace host_sim::calibrate_page {

/// Significant digits of what is read off a life test.
constexpr int kDigits = 4;

/// "830 to 920"; an end that does not exist is "no limit".
[[nodiscard]] std::string interval_text(statistics::Interval interval, int significant = kDigits);

/// The simulated p-value where there is one, else that of the chi-square distribution.
[[nodiscard]] double p_of(const statistics::Test& test);

/// Whether a test speaks against its hypothesis at 5 %.
[[nodiscard]] bool rejects(const statistics::Test& test);

/// Why a fit has no numbers; empty where it has.
[[nodiscard]] std::string problem_text(statistics::FitProblem problem);

}  // namespace host_sim::calibrate_page
