#pragma once

#include <Eigen/Core>

#include "host_sim/diagnose/audit/gram.hpp"

namespace host_sim::diagnose {

/// Inner products of all columns of a layout in the metric of the noise, c' V^-1 d, where
/// V is the noise of samples and Z D Z' in each session, Z the columns of gain and friction and D
/// the scatter of sessions. The root of a diagonal element is how many standard deviations a unit
/// of that column makes.
struct Projection {
  Eigen::MatrixXd before;
  Eigen::MatrixXd left;  ///< after the gain and friction of all sessions are projected off too
  /// By column: what of a diagonal element of `left` may be rounding.
  Eigen::VectorXd rounding;
};

/// Sums over sessions in their order, then takes the common gain and friction off. Directions of
/// these that the sessions do not show, to rounding, are left alone.
Projection project(const Grams& grams, const NoiseModel& noise);

}  // namespace host_sim::diagnose
