#pragma once

#include "host_sim/statistics/centred_sample.hpp"

namespace host_sim::statistics {

/// Normal distribution by maximum likelihood; the suspended count with their tail.
/// @pre sample.problem() is none
Fit fit_normal(const CentredSample& sample);

}  // namespace host_sim::statistics
