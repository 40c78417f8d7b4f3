#include "host_sim/calibrate/output/level_text.hpp"

namespace host_sim::calibrate {

std::string_view family_name(statistics::Family family) {
  switch (family) {
    case statistics::Family::normal:
      return "normal";
    case statistics::Family::lognormal:
      return "lognormal";
    case statistics::Family::weibull:
      return "weibull";
  }
  return "";
}

std::string_view problem_name(statistics::FitProblem problem) {
  switch (problem) {
    case statistics::FitProblem::none:
      return "";
    case statistics::FitProblem::too_few_failures:
      return "fewer than two failures";
    case statistics::FitProblem::no_spread:
      return "all failures at one life";
    case statistics::FitProblem::not_identified:
      return "the data do not determine it";
    case statistics::FitProblem::not_converged:
      return "the fit did not converge";
  }
  return "";
}

std::optional<statistics::Family> best_family(const LevelResult& level) {
  const statistics::Fit* best = nullptr;
  for (const statistics::Fit& fit : level.fits) {
    if (fit.problem == statistics::FitProblem::none &&
        (best == nullptr || fit.log_likelihood > best->log_likelihood)) {
      best = &fit;
    }
  }
  if (best == nullptr) {
    return std::nullopt;
  }
  return best->distribution.family;
}

std::string validation_name(const CalibrateResult& result, const ValidationResult& validation) {
  return validation.in_blocks ? "in blocks" : result.levels.at(validation.level).name();
}

}  // namespace host_sim::calibrate
