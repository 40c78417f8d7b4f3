#pragma once

#include <iosfwd>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Writes one self-contained HTML page: no network, no other file. Equal reports give equal bytes.
/// Numbers that are not finite are shown in words and embedded as null. Bytes that are not UTF-8
/// become U+FFFD. The state of `out` shows whether writing succeeded.
void write_replay_report(std::ostream& out, const ReplayReport& report);

}  // namespace host_sim
