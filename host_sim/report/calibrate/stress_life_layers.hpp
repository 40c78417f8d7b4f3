#pragma once

#include "host_sim/calibrate/result.hpp"
#include "host_sim/report/calibrate/law_lines.hpp"
#include "host_sim/report/page/chart.hpp"

/// Layers that the plots of life over tension share.
namespace host_sim::calibrate_page {

/// 95 % band of the mean, B10, mean and B90 of the law, and the paper's least squares.
void add_law(Chart& chart, const calibrate::StressLife& law, TensionRange range);

/// Specimens of constant load: fitted, validation, left out; suspended with arrows.
void add_specimens(Chart& chart, const calibrate::CalibrateResult& result);

/// Names of left-out levels over their longest lives.
void add_left_out_names(Chart& chart, const calibrate::CalibrateResult& result);

}  // namespace host_sim::calibrate_page
