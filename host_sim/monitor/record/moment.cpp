#include "host_sim/monitor/record/moment.hpp"

#include <algorithm>
#include <string_view>

#include "hal/files/input_file.hpp"
#include "host_sim/monitor/bus/frame_log.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"

namespace host_sim::monitor {

Moment moment_of(const FrameArchive& archive, const FleetView& now, std::int64_t time_us) {
  constexpr std::int64_t kNs = 1'000;
  const std::int64_t from_us = std::max<std::int64_t>(time_us - kMomentWindow_us, 0);
  Fleet fleet(now.bit_rate_bit_s);
  archive.read_from(from_us, [&](std::string_view lines) {
    CandumpLogReader reader(hal::files::memory_source(lines), "the record");
    while (auto seen = reader.next()) {
      if (seen->time_ns > time_us * kNs) {
        return false;
      }
      if (seen->time_ns >= from_us * kNs) {
        fleet.see(*seen);
      }
    }
    return true;
  });
  fleet.source_is(FrameSource::State::running, now.source);
  fleet.tick(time_us * kNs);
  return {.view = fleet.view(), .from_us = from_us};
}

}  // namespace host_sim::monitor
