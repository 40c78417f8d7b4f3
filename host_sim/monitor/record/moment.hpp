#pragma once

#include <cstdint>

#include "host_sim/monitor/fleet/node_view.hpp"
#include "host_sim/monitor/record/frame_archive.hpp"

namespace host_sim::monitor {

/// What the frames of an archive say of a moment of the past.
struct Moment {
  FleetView view;
  /// The frames since then were read. What was sent before is not known, and counts begin there.
  std::int64_t from_us = 0;
};

/// In this time a node sends each of its pages, also the bins of all its tendons.
inline constexpr std::int64_t kMomentWindow_us = std::int64_t{600} * 1'000'000;

/// A log has no later times.
inline constexpr std::int64_t kLatestMoment_us = 9'000'000'000'000'000;

/// Follows the frames of the last kMomentWindow_us before `time_us` as they were followed then. The
/// bus is that of `now`.
/// @param time_us 0 to kLatestMoment_us
/// @throws InputError for a line of the archive that is no frame
[[nodiscard]] Moment moment_of(const FrameArchive& archive, const FleetView& now,
                               std::int64_t time_us);

}  // namespace host_sim::monitor
