#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/report/page/chart.hpp"

namespace host_sim::calibrate_page {

/// The lowest and the highest tension of levels with constant load.
struct TensionRange {
  double low_N = 0;
  double high_N = 0;
};
/// Empty (low above high) without levels.
[[nodiscard]] TensionRange tested_tensions_N(const calibrate::CalibrateResult& result);

/// The same with the use levels.
[[nodiscard]] TensionRange all_tensions_N(const calibrate::CalibrateResult& result);

/// A line of life over tension, a little beyond both ends of the range; empty for an empty range.
[[nodiscard]] Layer law_line(TensionRange range,
                             const std::function<double(double tension_N)>& life_cycles);

/// "315°".
[[nodiscard]] std::string angle_text(double angle_deg);

}  // namespace host_sim::calibrate_page
