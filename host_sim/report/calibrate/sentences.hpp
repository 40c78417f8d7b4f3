#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/calibrate/result.hpp"

/// The sentences of the page: plain text, not yet escaped.
namespace host_sim::calibrate_page {

/// What the calibration found, in one or two sentences.
[[nodiscard]] std::string verdict(const calibrate::CalibrateResult& result);

/// What it was found from.
[[nodiscard]] std::string origin(const calibrate::CalibrateResult& result);

/// What the tests of one shape say, one sentence each.
[[nodiscard]] std::vector<std::string> shape_words(const calibrate::CalibrateResult& result);

/// What the tests of the life law say, one sentence each.
[[nodiscard]] std::vector<std::string> adequacy_words(const calibrate::CalibrateResult& result);

/// Which levels are left out and why, one sentence each.
[[nodiscard]] std::vector<std::string> left_out_words(const calibrate::CalibrateResult& result);

/// What each comparison with validation specimens says.
[[nodiscard]] std::vector<std::string> validation_words(const calibrate::CalibrateResult& result);

}  // namespace host_sim::calibrate_page

/// What to see in each plot: plain text, not yet escaped.
namespace host_sim::calibrate_page::captions {

[[nodiscard]] std::string lives(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string densities();
[[nodiscard]] std::string scale_by_tension();
[[nodiscard]] std::string scale_by_angle();
[[nodiscard]] std::string common_shape(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string stress_life(const calibrate::CalibrateResult& result);
[[nodiscard]] std::string stress_life_log();
[[nodiscard]] std::string use();
[[nodiscard]] std::string use_log();

}  // namespace host_sim::calibrate_page::captions
