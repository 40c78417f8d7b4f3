#include "host_sim/calibrate/problem_text.hpp"

namespace host_sim::calibrate {

std::string_view problem_text(statistics::FitProblem problem) {
  switch (problem) {
    case statistics::FitProblem::none:
      return "which converged";
    case statistics::FitProblem::too_few_failures:
      return "which needs at least 2 failures";
    case statistics::FitProblem::no_spread:
      return "because lives without scatter put the shape on its boundary, at infinity";
    case statistics::FitProblem::not_identified:
      return "because the data do not determine it: failures at two tensions at least are needed";
    case statistics::FitProblem::not_converged:
      return "because the likelihood did not converge to a maximum";
  }
  return "";
}

}  // namespace host_sim::calibrate
