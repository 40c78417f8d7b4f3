#pragma once

#include <cstdint>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// What is watched of a wire beside its damage, and what is advised to the drive. A limit of 0 is
/// off.
struct WatchLimits {
  static constexpr std::uint32_t kStandardHorizon_s = 8 * 3600;

  Tension minimum;  ///< input tension below which the wire is slack
  Tension broken;   ///< the most that friction alone makes, of a wire that broke
  /// Of the tendon; more than the slack that operation leaves to be taken up.
  std::uint32_t broken_travel_um = 0;
  std::uint32_t slack_travel_um = 0;  ///< of the tendon
  std::uint32_t horizon_s = 0;        ///< of the probability of a break; see horizon()
  Ratio advice_risk{};                ///< of a break that is accepted
  std::uint32_t advice_until_s = 0;   ///< of operation that the wire shall last at that risk

  [[nodiscard]] constexpr bool finds_broken() const {
    return broken.raw() > 0 && broken_travel_um > 0;
  }
  [[nodiscard]] constexpr bool finds_slack() const {
    return minimum.raw() > 0 && slack_travel_um > 0;
  }
  /// The horizon; the standard one where none was given.
  [[nodiscard]] constexpr std::uint32_t horizon() const {
    return horizon_s == 0 ? kStandardHorizon_s : horizon_s;
  }
  friend constexpr bool operator==(const WatchLimits&, const WatchLimits&) = default;
};

}  // namespace lifemodel
