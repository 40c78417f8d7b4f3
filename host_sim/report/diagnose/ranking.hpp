#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose_page {

/// The candidates as rows of a table with a bar each, the most probable first; those that are
/// hardly possible are told in a last row together. Texts are escaped. Empty without candidates.
[[nodiscard]] std::string ranking(const diagnose::Findings& findings);

}  // namespace host_sim::diagnose_page
