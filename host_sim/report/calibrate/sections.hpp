#pragma once

#include <string>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/report/page/sections.hpp"

/// Parts of the page as HTML with all texts escaped.
namespace host_sim::calibrate_page::sections {

using elements::chart;
using elements::table_or;
using elements::warnings;
using elements::words;

[[nodiscard]] std::string tiles(const calibrate::CalibrateResult& result);

/// A probability plot with its tables for each level.
[[nodiscard]] std::string probability_plots(const calibrate::CalibrateResult& result);

}  // namespace host_sim::calibrate_page::sections
