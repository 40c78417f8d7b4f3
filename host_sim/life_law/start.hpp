#pragma once

#include <Eigen/Core>

#include "host_sim/life_law/life_design.hpp"

namespace host_sim::life_law {

/// Coefficients to start from: least squares of ln cycles, as if the suspended had failed, with the
/// shape that belongs to the spread of what is left.
Eigen::VectorXd start_of(const LifeDesign& design);

}  // namespace host_sim::life_law
