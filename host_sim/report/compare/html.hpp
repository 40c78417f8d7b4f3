#pragma once

#include <iosfwd>
#include <string_view>
#include <vector>

#include "host_sim/report/compare/comparison.hpp"
#include "host_sim/report/page/chart.hpp"

namespace host_sim {

/// The plots that have something to show: damage by range of cycles, damage, input tension and
/// broken wires over time, of A and B in the same colours everywhere.
[[nodiscard]] std::vector<Chart> compare_charts(const compare::Comparison& comparison);

/// Writes one self-contained HTML page: what differs, and the plots. The state of `out` shows
/// whether writing succeeded.
void write_compare_report(std::ostream& out, const compare::Comparison& comparison,
                          std::string_view program_version);

}  // namespace host_sim
