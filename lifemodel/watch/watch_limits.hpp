#pragma once

#include <cstdint>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// When a wire counts as slack, and when as broken. A limit of 0 is off.
struct WatchLimits {
  Tension minimum;  ///< input tension below which the wire is slack
  Tension broken;   ///< the most that friction alone makes, of a wire that broke
  /// Of the tendon; more than the slack that operation leaves to be taken up.
  std::uint32_t broken_travel_um = 0;
  std::uint32_t slack_travel_um = 0;  ///< of the tendon

  [[nodiscard]] constexpr bool finds_broken() const {
    return broken.raw() > 0 && broken_travel_um > 0;
  }
  [[nodiscard]] constexpr bool finds_slack() const {
    return minimum.raw() > 0 && slack_travel_um > 0;
  }
  friend constexpr bool operator==(const WatchLimits&, const WatchLimits&) = default;
};

}  // namespace lifemodel
