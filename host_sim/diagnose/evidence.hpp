#pragma once

#include <Eigen/Core>
#include <vector>

#include "host_sim/diagnose/projection.hpp"

namespace host_sim::diagnose {

/// One value of the scatter of sessions that is tried, with all that follows from it.
struct ScatterPoint {
  NoiseModel noise;
  Eigen::MatrixXd left;         ///< Projection::left
  double log_determinants = 0;  ///< of the covariance of the responses and of the common terms
};

/// One value of the scatter, by itself.
/// @pre noise.sample_sd above 0
ScatterPoint scatter_point(const Grams& grams, const NoiseModel& noise);

/// The values of scatter_grid(), with a sample_sd that is not set.
std::vector<NoiseModel> scatter_values();

/// Scatter that is not known is averaged over: a grid in the logarithm of both standard deviations.
std::vector<ScatterPoint> scatter_grid(const Grams& grams, double sample_sd);

/// Columns that are in the model together, as indices into the layout, with the normal priors of
/// their coefficients.
struct Terms {
  std::vector<Eigen::Index> columns;
  std::vector<double> prior_mean;
  std::vector<double> prior_sd;

  void append(const Terms& other);
};

/// The terms of one block of an effect.
Terms terms_of(const GramLayout::Effect& effect, const GramLayout::Block& block);

/// ln of the probability of the responses under a model with these terms, up to a constant that is
/// the same for all models: coefficients integrated over their normal priors, common gain and
/// friction over flat ones, and the scatter of sessions over the grid; the variance of a sample at
/// its best, for the shares of the grid's variances given. The responses are column `response` of
/// the layout, of `samples` values in all.
double log_evidence(const std::vector<ScatterPoint>& grid, const Terms& terms,
                    Eigen::Index response, double samples);

}  // namespace host_sim::diagnose
