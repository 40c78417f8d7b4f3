#pragma once

#include <functional>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

struct CalibrateOptions {
  std::uint64_t seed = 1;
  std::size_t bootstraps = 10'000;
  unsigned threads = 0;          ///< 0: all cores; the result does not depend on it
  bool keep_all_levels = false;  ///< also those whose shape breaks the common one
  std::vector<double> use_tensions_N;
  std::function<void(double)> progress;  ///< called with the share done, 0 .. 1
};

/// The whole calibration. What cannot be computed is missing from the result and reported in its
/// warnings.
/// @throws InputError where the campaign holds no two failures of role fit
CalibrateResult calibrate(const Campaign& campaign, const CalibrateOptions& options);

}  // namespace host_sim::calibrate
