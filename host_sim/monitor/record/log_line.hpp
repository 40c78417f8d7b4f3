#pragma once

#include <string>
#include <string_view>

#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// The line that `candump -L` writes for what was seen, with its line end: data, remote and error
/// frames and those of CAN FD.
std::string log_line(const SeenFrame& seen, std::string_view interface);

}  // namespace host_sim::monitor
