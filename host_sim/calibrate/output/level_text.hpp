#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// `normal`, `lognormal` or `weibull`.
std::string_view family_name(statistics::Family family);

/// Why there is no fit, in a few words; empty where there is one.
std::string_view problem_name(statistics::FitProblem problem);

/// The family of the greatest likelihood (all have two parameters), none where none could be
/// fitted.
std::optional<statistics::Family> best_family(const LevelResult& level);

/// The level of a validation, or `in blocks`.
std::string validation_name(const CalibrateResult& result, const ValidationResult& validation);

}  // namespace host_sim::calibrate
