#pragma once

#include <span>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/calibrate/result.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::calibrate {

/// Fits, tests and bands of one level, by itself.
/// @param index number of the level, for its random numbers
LevelResult level_result(const Level& level, std::size_t index, const CalibrateOptions& options);

/// Finds the common shape of the levels of role fit, tests it, and marks as left out the level that
/// breaks it: where one shape is rejected at 5 % (simulated) and one level differs from the others
/// at 5 % after correction for having looked at each. Repeats while at least three levels are left.
/// Nothing with fewer than two levels that have a fit of their own.
std::optional<CommonShape> common_shape(std::span<LevelResult> levels,
                                        const CalibrateOptions& options);

/// The specimens that the life law is fitted to: role fit, those in blocks included, without levels
/// left out. Levels are numbered by their place in `levels`.
life_law::LifeData specimens_to_fit(const Campaign& campaign, std::span<const LevelResult> levels,
                                    std::span<const Level> sources);

/// The specimens of one level, with the number that it shall have.
life_law::LifeData level_specimens(const Level& level, std::size_t number);

/// Validation specimens loaded in blocks.
life_law::LifeData validation_in_blocks(const Campaign& campaign);

}  // namespace host_sim::calibrate
