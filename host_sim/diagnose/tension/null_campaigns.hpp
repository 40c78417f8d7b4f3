#pragma once

#include <Eigen/Core>
#include <vector>

#include "host_sim/diagnose/tension/scatter_score.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::diagnose {

/// Draws X'y of campaigns of the same design that hold noise and scatter of sessions alone. The
/// coefficients of a model stay zero: what is refitted does not change what is left.
class NullCampaigns {
 public:
  /// @param grams must outlive this
  explicit NullCampaigns(const Grams& grams);

  [[nodiscard]] Products draw(const NoiseModel& noise, statistics::Random& random) const;

 private:
  /// What the columns of a session make of white noise of unit size.
  struct SessionNoise {
    Eigen::Matrix2d common_root;     ///< of the products with gain and friction
    Eigen::MatrixXd rest_of_common;  ///< the others' expected products, by those
  };

  const Grams& grams_;
  std::vector<SessionNoise> sessions_;
  Eigen::MatrixXd rest_root_;  ///< of the others' products beside that, of all sessions
};

}  // namespace host_sim::diagnose
