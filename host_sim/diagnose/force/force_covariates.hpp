#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

/// What residuals may depend on, by direction.
struct ForceCovariate {
  std::string_view name;
  std::string_view unit;
  std::vector<std::vector<double>> values;  ///< by record and sample
  bool of_sessions = false;                 ///< each session has one of its own
  bool noisy = false;                       ///< with noise that residuals of a model have too
};

/// Size of the output force, position, speed and travel since the motion turned, in the order of
/// kEmpiricalCovariates; after these rate of the output force, acceleration and time, which no
/// correction is made of; then those of whole sessions that there are and that differ: cycle of the
/// tendon's life, bend angle, temperatures of sheath and winding.
std::vector<ForceCovariate> force_covariates(const std::vector<effects::ForceRecord>& records);

/// Bins of a covariate that hold as many samples each, and which one each sample lies in: an even
/// number where the motion goes one way, the next one where it goes back. What is noisy is smoothed
/// over half the mean time between reversals: else samples lie in a bin by what their residuals
/// are.
struct CovariateBins {
  static constexpr std::size_t kCount = 8;

  CovariateBins(const std::vector<effects::ForceRecord>& records, const ForceCovariate& covariate);

  bool of_sessions = false;  ///< see ForceCovariate
  std::vector<double> centres;
  std::vector<std::vector<std::size_t>> places;  ///< by record and sample
};

}  // namespace host_sim::diagnose
