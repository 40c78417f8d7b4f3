#pragma once

#include <Eigen/Core>

#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/log_tension_frame.hpp"
#include "host_sim/life_law/participation.hpp"

namespace host_sim::life_law {

/// Coefficients of a design out of those of a fit, whose centre may be another.
Eigen::VectorXd design_coefficients(const LifeFit& fit, const LogTensionFrame& frame,
                                    const Participation& participation);

/// Sets centre and coefficients of a fit; a level without a part gets an infinite ln alpha, and its
/// ln beta is not a number.
void set_coefficients(LifeFit& fit, const Eigen::VectorXd& coefficients,
                      const LogTensionFrame& frame, const Participation& participation);

}  // namespace host_sim::life_law
