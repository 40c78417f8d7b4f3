#pragma once

#include <cstdint>
#include <span>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// Samples of which the full cycles that close among themselves, whatever came before and comes
/// after, have been counted and taken out.
struct Stretch {
  std::span<const Tension> left;  ///< what remains of the samples
  std::uint64_t cycles = 0;       ///< full cycles that were taken out
  Damage damage;                  ///< of these
  std::uint32_t nesting = 0;      ///< places of the residue that all the samples may take at most
};

}  // namespace lifemodel
