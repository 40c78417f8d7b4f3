#pragma once

#include "host_sim/report/replay/report_data.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/tendon.hpp"

namespace host_sim {

/// What lets the wire last, by the fixed-point code that a board gives its advice with; see
/// lifemodel/life/advice.hpp.
/// @param peak of the profile by its size
/// @param least_N tension below which a wire is slack
UntilDate until_date(const AskedUntil& asked, double used, const lifemodel::Reading& reading,
                     lifemodel::Tension peak, double duration_s,
                     const lifemodel::Parameters& parameters, double ultimate_tension_N,
                     double least_N);

}  // namespace host_sim
