#pragma once

#include <Eigen/Core>
#include <span>

#include "host_sim/diagnose/gram.hpp"

namespace host_sim::diagnose {

/// What varies beside the effects.
struct NoiseModel {
  double sample_sd = 0.01;             ///< of ln T_out - ln T_in of one sample, after whitening
  double session_gain_sd = 0.01;       ///< of the gain of a session, in ln
  double session_friction_sd = 0.006;  ///< of the friction coefficient of a session
  /// Refit gain and friction of each session freely, as with infinite scatter: only what changes
  /// within a session counts.
  bool free_sessions = false;
};

/// Inner products of all columns of a layout in the metric of the noise, c' V^-1 d, where
/// V = sample_sd^2 I + Z D Z' in each session, Z = [1, -phi s] and D the scatter of sessions. The
/// root of a diagonal element is how many standard deviations a unit of that column makes.
struct Projection {
  Eigen::MatrixXd before;  ///< with free sessions: the plain one, over sample_sd^2
  Eigen::MatrixXd left;    ///< after the gain and friction of all sessions are projected off too
  /// By column: what of a diagonal element of `left` may be rounding.
  Eigen::VectorXd rounding;
};

/// A generalised inverse of a symmetric matrix of sums of products over the samples.
Eigen::Matrix2d inverse_of_products(const Eigen::Matrix2d& matrix);

/// c' V^-1 d of one session; size() x size() of the layout. @pre sample_sd above 0
Eigen::MatrixXd session_information(const SessionGram& session, const NoiseModel& noise);

/// What every value of the noise needs of all sessions: once for many projections.
struct GramSums {
  explicit GramSums(const Grams& grams);

  Eigen::MatrixXd total;   ///< of the Gram matrices; size() x size() of the layout
  Eigen::MatrixXd common;  ///< their first two columns, session after session; size() x 2 sessions
};

/// Sums over sessions in their order, then takes the common gain and friction off. Directions of
/// these that the sessions do not show, to rounding, are left alone.
Projection project(const GramSums& sums, const NoiseModel& noise);
Projection project(const Grams& grams, const NoiseModel& noise);

}  // namespace host_sim::diagnose
