#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host_sim/diagnose/gram.hpp"
#include "host_sim/diagnose/tension/hypothesis.hpp"
#include "host_sim/diagnose/tension/noise.hpp"

namespace host_sim::diagnose {

/// Gain, friction and the sizes of a model's effects, as the columns of a layout have them, with
/// the scatter of sessions that suits them best.
struct ModelFit {
  NoiseModel noise;
  /// Gain, friction (added to the nominal mu), then the effects in order of the layout's columns.
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
  /// The same, of sessions that scatter as wholes whatever the model says (sandwich).
  Eigen::MatrixXd covariance_by_sessions = {};
  double degrees_of_freedom = 0;  ///< of that
};

/// Generalised least squares with the priors of `terms`; those of gain and friction are flat.
/// @param sessions those to fit, by their places in `grams`
ModelFit fit_model(const Grams& grams, const Terms& terms, std::span<const std::size_t> sessions,
                   double sample_sd);

/// All sessions.
ModelFit fit_model(const Grams& grams, const Terms& terms, double sample_sd);

/// What a fitted model makes of one session, sample by sample.
struct Predicted {
  std::vector<double> output_N;  ///< from T_in as measured alone
  std::vector<double> input_N;   ///< from T_out as measured alone
};

/// @param layout of the model alone; `fit` has its coefficients in order of its columns
Predicted predict(const Session& session, const GramLayout& layout,
                  const effects::Baseline& baseline, const ModelFit& fit);

/// A model fitted to all sessions, with the matrices that it was fitted by.
struct Fitted {
  Grams grams;
  ModelFit fit;
};

/// @param model no parts: the nominal one
Fitted fitted(const Evidence& evidence, std::span<const Component> model);

Predicted predict(const Session& session, const Fitted& by);

/// Weights of samples, hardly any to those that a model leaves far outside of the others' scatter
/// once gain and friction of their session are refitted: at the edges of what sets in at once,
/// samples lie on the other side than the model has them.
SampleWeights weights_without_outliers(const Evidence& evidence, std::span<const Component> model);

/// The friction coefficient that samples far from any reversal have, with a gain for each session:
/// what acts at reversals alone does not reach them.
/// @param nominal taken where they do not show it, or differ from it by more than a factor of four
double settled_friction(std::span<const Session> sessions, double nominal);

/// Signatures are in terms of the friction that is there, which that of the evidence's baseline is
/// only near to, and some in terms of their own size. Takes both from the model's fit, and looks
/// anew, and closer, for the shapes of what acts at reversals, which change with them. In turns,
/// until all hardly change.
std::vector<Component> refined(Evidence& evidence, std::vector<Component> model);

/// Takes the friction of the model's fit alone: its shapes stay, and its sizes go with the
/// friction.
void take_friction_of(Evidence& evidence, std::vector<Component> model);

}  // namespace host_sim::diagnose
