#pragma once

#include "host_sim/calibrate/calibrate.hpp"

namespace host_sim::calibrate {

/// Fits, tests and bands of one level, by itself.
/// @param index number of the level, for its random numbers
LevelResult level_result(const Level& level, std::size_t index, const CalibrateOptions& options);

/// Why a level has no Weibull fit of its own, with the line of its first specimen; empty where it
/// has one.
std::string level_warning(const Campaign& campaign, const Level& level, const LevelResult& result);

}  // namespace host_sim::calibrate
