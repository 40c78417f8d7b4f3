#pragma once

#include <string>

#include "host_sim/statistics/common_shape.hpp"

namespace host_sim::calibrate {

/// Four significant digits; `-` for what was not computed, `no limit` for what is infinite.
std::string figure(double value);

/// `low .. high`.
std::string figure(const statistics::Interval& interval);

/// Cycles: whole below a million, four significant digits above.
std::string cycles_text(double cycles);
std::string cycles_text(const statistics::Interval& interval_cycles);

/// A p-value with three decimals, below 0.001 with one significant digit.
std::string p_text(double p);

}  // namespace host_sim::calibrate
