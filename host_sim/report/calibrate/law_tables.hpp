#pragma once

#include <string>

#include "host_sim/calibrate/result.hpp"

/// The tables about the life law, as HTML with all texts escaped.
namespace host_sim::calibrate_page::tables {

/// Parameters with intervals, beside the paper's least squares.
[[nodiscard]] std::string law(const calibrate::CalibrateResult& result);

/// B10, mean with band, and B90 over tension.
[[nodiscard]] std::string law_lines(const calibrate::CalibrateResult& result);

[[nodiscard]] std::string use_levels(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string validation(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string mixes(const calibrate::CalibrateResult& result);

}  // namespace host_sim::calibrate_page::tables
