#pragma once

#include <string>
#include <vector>

#include "host_sim/calibrate/result.hpp"

/// Results of calibrations made by hand: what is in them is plausible, not computed.
namespace host_sim::samples {

struct CalibrateSample {
  std::string name;
  std::size_t charts;  ///< plots that the page has to draw
  calibrate::CalibrateResult result;
};

/// Like the paper's: four fitted levels, one left out, one for validation; one suspended specimen,
/// two use levels, a mix, two warnings.
[[nodiscard]] calibrate::CalibrateResult paper_like();

/// Names and reasons that try to leave the place they are put in.
[[nodiscard]] calibrate::CalibrateResult hostile_campaign();

/// Pages at the edges of what a calibration can find.
[[nodiscard]] std::vector<CalibrateSample> all_calibrations();

}  // namespace host_sim::samples
