#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/reference/paper.hpp"

namespace host_sim::reference::testing {

/// Compares the table `| quantity | paper | ours | why |` between the paper-table markers of a
/// Markdown text with the rows: each quantity once, no other, the paper's numbers as printed, ours
/// within half a unit of the last digit shown, a reason for each. Returns what is wrong, one line a
/// fault; empty where all is well.
std::vector<std::string> faults_of_paper_table(const std::string& markdown,
                                               std::span<const PaperRow> rows);

}  // namespace host_sim::reference::testing
