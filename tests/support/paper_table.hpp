#pragma once

#include <span>
#include <string>
#include <vector>

namespace host_sim::testing {

/// A quantity as the paper prints it and as its own equations and constants give it.
struct PaperRow {
  std::string quantity;
  std::vector<double> paper;
  std::vector<double> ours;
};

/// Compares the table `| quantity | paper | ours | why |` between `<!-- MARK:begin -->` and
/// `<!-- MARK:end -->` of a Markdown text with the rows: each quantity once, no other, the paper's
/// numbers as printed, ours within half a unit of the last digit shown, a reason for each. Returns
/// what is wrong, one line a fault; empty where all is well.
std::vector<std::string> faults_of_paper_table(const std::string& markdown, const std::string& mark,
                                               std::span<const PaperRow> rows);

}  // namespace host_sim::testing
