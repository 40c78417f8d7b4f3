#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"

/// Tables of the page as HTML with all texts escaped.
namespace host_sim::diagnose_page::tables {

[[nodiscard]] std::string effects(const diagnose::Findings& findings);
[[nodiscard]] std::string parameters(const diagnose::Findings& findings);
[[nodiscard]] std::string refitted(const diagnose::Findings& findings);
[[nodiscard]] std::string equivalents(const diagnose::Findings& findings);
[[nodiscard]] std::string invisible(const diagnose::Findings& findings);
[[nodiscard]] std::string gain(const diagnose::HeldOutGain& gain);
[[nodiscard]] std::string steps(const std::vector<diagnose::Step>& steps);
[[nodiscard]] std::string discrepancies(const diagnose::Findings& findings);

/// The candidates as rows of a table with a bar each, the most probable first; those that are
/// hardly possible are reported in a last row together. Texts are escaped. Empty without
/// candidates.
[[nodiscard]] std::string ranking(const diagnose::Findings& findings);

}  // namespace host_sim::diagnose_page::tables
