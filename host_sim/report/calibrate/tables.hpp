#pragma once

#include <cstddef>
#include <string>

#include "host_sim/calibrate/result.hpp"

/// The tables about levels and about the life law, as HTML with all texts escaped.
namespace host_sim::calibrate_page::tables {

/// Scale, shape and mean life of each level (the paper's Table 4).
[[nodiscard]] std::string levels(const calibrate::CalibrateResult& result);

/// K-S and A-D with bootstrap p-values for three families (the paper's Table 3).
[[nodiscard]] std::string goodness_of_fit(const calibrate::CalibrateResult& result);

/// The lives of every specimen of constant load.
[[nodiscard]] std::string specimens(const calibrate::CalibrateResult& result);

/// Plotting positions of one level beside its fit.
[[nodiscard]] std::string positions(const calibrate::LevelResult& level);

/// The fit of one level and its 95 % band at round shares.
[[nodiscard]] std::string band(const calibrate::LevelResult& level);

/// Common shape with its interval, its tests, and each level against the others; without rows where
/// there is none.
[[nodiscard]] std::string common_shape(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string shape_tests(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string odd_levels(const calibrate::CalibrateResult& result);

/// Parameters with intervals, beside the paper's least squares.
[[nodiscard]] std::string law(const calibrate::CalibrateResult& result);

/// B10, mean with band, and B90 over tension.
[[nodiscard]] std::string law_lines(const calibrate::CalibrateResult& result);

[[nodiscard]] std::string use_levels(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string validation(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string mixes(const calibrate::CalibrateResult& result);

}  // namespace host_sim::calibrate_page::tables
