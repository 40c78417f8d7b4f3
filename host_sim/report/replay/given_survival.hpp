#pragma once

#include <string>

#include "host_sim/report/page/chart.hpp"
#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Risk of a break over repeats from now on: the wire with the interval of the fit and its 10, 50
/// and 90 %, and a new wire. No layers without damage or where it was not asked for.
[[nodiscard]] Chart break_chart(const ReplayReport& report);

}  // namespace host_sim

namespace host_sim::sections {

/// The section of a wire that is whole now, as HTML with all texts escaped; empty where it was not
/// asked for.
[[nodiscard]] std::string given_survival(const ReplayReport& report);

}  // namespace host_sim::sections
