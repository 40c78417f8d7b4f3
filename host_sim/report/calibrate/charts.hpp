#pragma once

#include <vector>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/report/page/chart.hpp"

/// The plots of the page of a calibration. Figure numbers are the paper's. A chart without anything
/// to show has no layers.
namespace host_sim::calibrate_page {

/// Every specimen's life by level, with the mean of each (Fig. 8).
[[nodiscard]] Chart lives_chart(const calibrate::CalibrateResult& result);

/// The Weibull densities of the levels, with their mean lives and specimens (Fig. 10).
[[nodiscard]] Chart density_chart(const calibrate::CalibrateResult& result);

/// Scale parameters against effective tension (Fig. 11) with 95 % intervals and the law.
[[nodiscard]] Chart scale_by_tension_chart(const calibrate::CalibrateResult& result);

/// Scale parameters against bend angle (Fig. 11).
[[nodiscard]] Chart scale_by_angle_chart(const calibrate::CalibrateResult& result);

enum class StressLifeAxes { linear, logarithmic };

/// The law with its specimens (Fig. 12).
[[nodiscard]] Chart stress_life_chart(const calibrate::CalibrateResult& result,
                                      StressLifeAxes axes);

/// The law at use and validation levels (Fig. 15).
[[nodiscard]] Chart use_chart(const calibrate::CalibrateResult& result, StressLifeAxes axes);

/// The probability plot of one level with its fit and 95 % band.
[[nodiscard]] Chart probability_chart(const calibrate::CalibrateResult& result, std::size_t level);

/// The failures of all levels with lines of the common shape.
[[nodiscard]] Chart common_shape_chart(const calibrate::CalibrateResult& result);

/// All of the above that have something to show, in the order of the page.
[[nodiscard]] std::vector<Chart> charts(const calibrate::CalibrateResult& result);

}  // namespace host_sim::calibrate_page
