#pragma once

#include <cstdint>

#include "host_sim/life_law/life_data.hpp"

namespace host_sim::life_law::testing {

inline constexpr LifeLaw kPaperLaw{.scale = 1.53e5, .exponent = 1.38, .shape = 5.94};

/// Four levels like the paper's (42.5 to 70.8 N) of `each` specimens with lives out of the law.
LifeData paper_like(std::uint64_t seed, std::size_t each = 20, const LifeLaw& law = kPaperLaw);

/// The same, and lives beyond `limit_cycles` are suspended there.
LifeData suspended_at(LifeData data, double limit_cycles);

/// Specimens in blocks of 40 to 80 N, `share` of the mean life each, until they fail or, every
/// third, after six blocks.
LifeData in_blocks(std::uint64_t seed, std::size_t count, double share,
                   const LifeLaw& law = kPaperLaw);

}  // namespace host_sim::life_law::testing
