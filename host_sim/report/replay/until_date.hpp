#pragma once

#include <string>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim::sections {

/// The section of what lets the wire last until a date, as HTML with all texts escaped; empty where
/// it was not asked for.
[[nodiscard]] std::string until_date(const ReplayReport& report);

}  // namespace host_sim::sections
