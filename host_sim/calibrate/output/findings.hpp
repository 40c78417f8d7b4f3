#pragma once

#include <string>
#include <vector>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// The simulated p-value where there is one, else that of the chi-square distribution.
double p_of(const Test& test);

/// A p-value that was not computed rejects nothing.
bool rejected(const Test& test);

/// All that found_in() can name, in its order.
std::vector<std::string> all_findings();

/// What speaks against the model or its data:
///   left-out    a level of role fit is not in the life model;
///   shape       one shape for all levels of the life model is rejected;
///   fit         the law is rejected against free levels, curvature or growing scatter, or there is
///               none;
///   validation  a validation level differs from its prediction.
std::vector<std::string> found_in(const CalibrateResult& result);

}  // namespace host_sim::calibrate
