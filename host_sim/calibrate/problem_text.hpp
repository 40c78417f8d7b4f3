#pragma once

#include <string_view>

#include "host_sim/statistics/fit.hpp"

namespace host_sim::calibrate {

/// Why a fit does not exist, and what it would need.
std::string_view problem_text(statistics::FitProblem problem);

}  // namespace host_sim::calibrate
