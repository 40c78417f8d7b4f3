#pragma once

#include <string>

#include "host_sim/report/page/chart.hpp"
#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Output tension over input tension with the direction of travel; without layers where the profile
/// has no output tension.
[[nodiscard]] Chart loop_chart(const ReplayReport& report);

namespace sections {

/// The chart with its caption; empty without it.
[[nodiscard]] std::string loop(const ReplayReport& report);

}  // namespace sections
}  // namespace host_sim
