#pragma once

#include <iosfwd>
#include <string_view>

#include "host_sim/fmeca/assessment.hpp"

namespace host_sim {

/// Writes one self-contained HTML page: the criticality matrix, the failure modes by rank with what
/// watches them, and what nothing watches. The state of `out` shows whether writing succeeded.
void write_fmeca_report(std::ostream& out, const fmeca::Assessment& assessment,
                        std::string_view program_version);

}  // namespace host_sim
