#pragma once

#include <iosfwd>
#include <string_view>

#include "host_sim/design/study.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// Writes one self-contained HTML page of a design: its numbers, life over output tension at
/// several bend angles with the design marked, the effective tension over the bend angle (the
/// paper's Fig. 5), a tornado of elasticities, and the acceleration factors of tests. The state of
/// `out` shows whether writing succeeded.
void write_design_report(std::ostream& out, const Model& model, const design::Study& study,
                         const design::Telling& telling, std::string_view program_version);

}  // namespace host_sim
