#include "host_sim/report/calibrate/texts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {

std::string interval_text(statistics::Interval interval, int significant) {
  const auto end = [significant](double value) {
    return std::isinf(value) ? std::string("no limit") : number_text(value, significant);
  };
  return fmt::format("{} to {}", end(interval.low), end(interval.high));
}

double p_of(const statistics::Test& test) {
  return std::isnan(test.p_simulated) ? test.p_chi_square : test.p_simulated;
}

bool rejects(const statistics::Test& test) {
  constexpr double kSignificance = 0.05;
  return p_of(test) < kSignificance;
}

std::string problem_text(statistics::FitProblem problem) {
  switch (problem) {
    case statistics::FitProblem::too_few_failures:
      return "fewer than two failures";
    case statistics::FitProblem::no_spread:
      return "all failures at one life";
    case statistics::FitProblem::not_identified:
      return "the data do not determine it";
    case statistics::FitProblem::not_converged:
      return "the fit did not converge";
    case statistics::FitProblem::none:
      break;
  }
  return {};
}

}  // namespace host_sim::calibrate_page
