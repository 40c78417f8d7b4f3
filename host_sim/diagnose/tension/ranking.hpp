#pragma once

#include <vector>

#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// The nominal model, each effect by itself and the pairs that hold one of the best of these.
struct Ranking {
  Hypothesis none;
  std::vector<Hypothesis> singles;  ///< best first
  std::vector<Hypothesis> pairs;    ///< best first

  /// The best of all.
  [[nodiscard]] const Hypothesis& best() const;
};

/// The best that each effect by itself and the nominal model give, without a closer look.
/// @param grams of the wanted effects with all their shapes
Hypothesis best_at_first(const Evidence& evidence, const Grams& grams);

/// Every candidate, and two at once, by their evidence.
/// @param grams of the wanted effects with all their shapes
Ranking rank(const Evidence& evidence, const Grams& grams);

}  // namespace host_sim::diagnose
