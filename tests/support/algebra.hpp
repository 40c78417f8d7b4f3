#pragma once

#include <Eigen/Core>

namespace host_sim::algebra {

// By the decompositions of Eigen, compiled once: each takes a compiler seconds.

/// Of a square matrix that has an inverse.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);
Eigen::MatrixXd solved(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
double determinant(const Eigen::MatrixXd& matrix);

/// `right` less what the columns explain of it by least squares.
Eigen::MatrixXd left_by(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& right);

}  // namespace host_sim::algebra
