#pragma once

#include <span>

#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// How the sensor of an output force is late: 0 where it lags, 1 where it reads what was.
struct LateOutput {
  double as_delay = 0.5;
  double error = 0;  ///< standard error, of sessions that scatter
};

/// A delay tau is a lag and tau^2/2 of the force's second derivative besides. That is sought at
/// every second sample along what the other samples show of it, whose noise is another, so that it
/// leaves no trace. Each session has its own gain and friction; samples near a reversal stay out.
/// @param all data as sampled, by their weights
/// @param records of the same samples, not smoothed
/// @param lagging a model with ForceTerm::lag of the output
LateOutput late_output(const ForceData& all, std::span<const effects::ForceRecord> records,
                       const ForceFit& lagging);

}  // namespace host_sim::diagnose
