#pragma once

#include <span>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/life_law/life_data.hpp"

namespace host_sim::calibrate {

/// The specimens that the life law is fitted to: role fit, those in blocks included, without levels
/// left out. Levels are numbered by their place in `levels`.
life_law::LifeData specimens_to_fit(const Campaign& campaign, std::span<const LevelResult> levels,
                                    std::span<const Level> sources);

/// The specimens of one level, with the number that it shall have.
life_law::LifeData level_specimens(const Level& level, std::size_t number);

/// Validation specimens loaded in blocks.
life_law::LifeData validation_in_blocks(const Campaign& campaign);

}  // namespace host_sim::calibrate
