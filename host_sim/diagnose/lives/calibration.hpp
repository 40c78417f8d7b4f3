#pragma once

#include <map>
#include <string>

namespace host_sim::diagnose::lives {

/// What turns evidence into probabilities that come true as often as they say. Fitted on campaigns
/// that were simulated for it, see calibration.cpp.
struct Calibration {
  double power = 1;  ///< of the evidence
  /// ln of the prior odds against nothing being wrong: of all single effects together, of all pairs
  /// and of all that is outside.
  double ln_single = 0, ln_pair = 0, ln_outside = 0;
  /// ln of the prior odds of an effect against the mean of those that a campaign can show; of a
  /// pair both count. 0 where an effect has none.
  std::map<std::string, double> ln_weights = {};

  [[nodiscard]] double ln_weight(const std::string& effect) const;
};

const Calibration& calibration();

}  // namespace host_sim::diagnose::lives
