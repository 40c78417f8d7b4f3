#pragma once

#include <string>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim::samples {

struct Sample {
  std::string name;
  int charts;  ///< plots that the page has to draw
  ReplayReport report;
};

/// 60 s of a noisy upper-arm motion, 14..55 N: few enough samples to draw the turning points, and
/// enough for a band.
[[nodiscard]] ReplayReport typical();

/// The typical motion with a wire that is whole at `damage`, as replay makes it.
/// @param with_interval the model says how well its life is known
[[nodiscard]] ReplayReport survivor(double damage, const std::string& horizon, bool with_interval);

/// Texts that try to leave the place they are put in, and letters beyond ASCII.
[[nodiscard]] ReplayReport hostile();

/// Pages at the edges of what a replay can find, `typical` and `hostile` among them.
[[nodiscard]] std::vector<Sample> all();

}  // namespace host_sim::samples
