#pragma once

#include <optional>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate_page {

/// The interval of a Weibull scale, which is the life at which 63.2 % have failed, read off the
/// band of the quantiles: straight between its points on probability paper. None where the band
/// does not reach there.
[[nodiscard]] std::optional<statistics::Interval> scale_interval(
    const statistics::QuantileBand& band);

}  // namespace host_sim::calibrate_page
