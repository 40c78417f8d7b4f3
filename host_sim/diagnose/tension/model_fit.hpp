#pragma once

#include <Eigen/Core>
#include <span>

#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// Gain, friction and the sizes of a model's effects, as the columns of a layout have them, with
/// the scatter of sessions that suits them best.
struct ModelFit {
  NoiseModel noise;
  /// Gain, friction (added to the nominal mu), then the effects in order of the layout's columns.
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
};

/// Generalised least squares with the priors of `terms`; those of gain and friction are flat.
/// @param sessions those to fit, by their places in `grams`
ModelFit fit_model(const Grams& grams, const Terms& terms, std::span<const std::size_t> sessions,
                   double sample_sd);

/// All sessions.
ModelFit fit_model(const Grams& grams, const Terms& terms, double sample_sd);

}  // namespace host_sim::diagnose
