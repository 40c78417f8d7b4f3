#pragma once

#include <string>
#include <vector>

#include "tests/support/paper_table.hpp"

namespace host_sim::reference::testing {

using host_sim::testing::PaperRow;

/// Every quantity of the paper that the reference model reproduces, computed on each call.
std::vector<PaperRow> paper_rows();

/// Effective tension at 270, 315, 360, 405, 450, 540 degrees under 49 N, and that of the upper-arm
/// application.
std::vector<double> effective_tensions_N(double friction_coefficient);

/// The inverse power law that fits the scale parameters of 315 to 450 degrees in Table 4 with the
/// smallest sum of squares, and its root mean square error over the four.
struct LeastSquares {
  double ipl_scale;
  double ipl_exponent;
  double rms_cycles;
};
LeastSquares fit_table_4();

}  // namespace host_sim::reference::testing
