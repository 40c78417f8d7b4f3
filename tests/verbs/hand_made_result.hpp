#pragma once

#include "host_sim/calibrate/result.hpp"

/// Results and campaigns made by hand: what is in them is plausible, not computed.
namespace host_sim_test {

/// Two levels of role fit, one left out, one for validation; a law, one use level and one mix.
host_sim::calibrate::CalibrateResult hand_made_result();

/// Nothing could be fitted: one level with one failure.
host_sim::calibrate::CalibrateResult result_without_fits();

/// A nominal model with all that --out needs, a drive too.
host_sim::Campaign campaign_with_model();

}  // namespace host_sim_test
