#pragma once

#include <Eigen/Core>
#include <functional>

namespace host_sim::diagnose::lives {

using Function = std::function<double(const Eigen::VectorXd&)>;

/// From zero in each coordinate: how far a maximum is looked for.
inline constexpr double kFarthest = 30;

/// Where a smooth function of a few variables, all of the order of 1, is largest near `start`:
/// sequential quadratic programming of NLopt with gradients by central differences, again from
/// where it ends as long as that gains.
Eigen::VectorXd maximize(const Function& function, const Eigen::VectorXd& start);

/// Second derivatives by central differences.
Eigen::MatrixXd hessian(const Function& function, const Eigen::VectorXd& at);

}  // namespace host_sim::diagnose::lives
