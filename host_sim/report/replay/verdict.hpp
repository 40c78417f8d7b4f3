#pragma once

#include <string>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// What the replay found, in one sentence for people (plain text, UTF-8).
[[nodiscard]] std::string verdict(const ReplayReport& report);

}  // namespace host_sim
