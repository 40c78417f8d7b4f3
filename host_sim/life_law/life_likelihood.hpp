#pragma once

#include <Eigen/Core>

#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/newton.hpp"

namespace host_sim::life_law {

/// Log of the steepest shape that is looked at: lives that scatter by less than 1e-8 do not.
inline constexpr double kLargestLnShape = 20;

/// Log likelihood of a design with densities per cycle, its gradient and Hessian; minus infinity
/// where a shape is steeper than the steepest.
/// @param coefficients those of ln alpha, then those of ln beta
void expand_log_likelihood(const LifeDesign& design, const Eigen::VectorXd& coefficients,
                           Expansion& expansion);

/// The largest ln beta of a specimen.
double largest_ln_shape(const LifeDesign& design, const Eigen::VectorXd& coefficients);

}  // namespace host_sim::life_law
