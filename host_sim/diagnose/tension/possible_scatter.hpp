#pragma once

#include <vector>

#include "host_sim/diagnose/tension/scatter_score.hpp"

namespace host_sim::diagnose {

/// The values of the scatter of sessions that the measured campaign makes possible.
class PossibleScatter {
 public:
  /// Of scatter_values() with this sample_sd.
  /// @param grams must outlive this
  /// @param refitted how many columns are, as in ScatterScore
  PossibleScatter(const Grams& grams, double sample_sd, Eigen::Index refitted,
                  const Products& measured);

  /// ScatterScore::deviance() of each value.
  [[nodiscard]] std::vector<double> deviances(const Products& products) const;

  /// Where the deviance is least.
  [[nodiscard]] const ScatterScore& best(const Products& products) const;

  /// The value that a uniform number draws from the posterior of these deviances, under a prior
  /// that is flat over the grid.
  [[nodiscard]] const ScatterScore& drawn(const std::vector<double>& deviances,
                                          double uniform) const;

 private:
  const Grams& grams_;
  std::vector<ScatterScore> scores_;
};

}  // namespace host_sim::diagnose
