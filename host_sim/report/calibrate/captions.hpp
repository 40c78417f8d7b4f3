#pragma once

#include <string>
#include <string_view>

#include "host_sim/calibrate/result.hpp"

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
