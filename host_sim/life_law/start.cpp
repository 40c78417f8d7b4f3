#include "host_sim/life_law/start.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace host_sim::life_law {
namespace {

struct NormalEquations {
  explicit NormalEquations(Eigen::Index size)
      : matrix(Eigen::MatrixXd::Zero(size, size)), right(Eigen::VectorXd::Zero(size)) {}

  /// Adds `number` values with one row.
  void add(const Eigen::VectorXd& row, double number, double sum, double sum_of_squares) {
    matrix += number * row * row.transpose();
    right += sum * row;
    squares += sum_of_squares;
    count += number;
  }

  /// A little of the identity keeps what the data do not determine near zero.
  [[nodiscard]] Eigen::VectorXd solve() const {
    constexpr double kRidge = 1e-9;
    const Eigen::Index size = right.size();
    return (matrix + kRidge * count * Eigen::MatrixXd::Identity(size, size)).ldlt().solve(right);
  }

  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  double squares = 0;
  double count = 0;
};

double ln_sum(const Eigen::VectorXd& ln_parts) {
  return std::log(ln_parts.array().exp().sum());
}

NormalEquations normal_equations(const LifeDesign& design) {
  NormalEquations equations(design.scale_coefficients);
  for (const LifeDesign::Constant& group : design.constant) {
    double sum = 0;
    double squares = 0;
    for (const LifeDesign::Constant::Life& life : group.lives) {
      sum += life.ln_cycles;
      squares += life.ln_cycles * life.ln_cycles;
    }
    equations.add(group.scale_row, static_cast<double>(group.lives.size()), sum, squares);
  }
  for (const LifeDesign::InBlocks& specimen : design.in_blocks) {
    const double ln_cycles = ln_sum(specimen.ln_cycles);
    const Eigen::VectorXd shares = (specimen.ln_cycles.array() - ln_cycles).exp();
    equations.add(specimen.scale_rows * shares, 1, ln_cycles, ln_cycles * ln_cycles);
  }
  return equations;
}

}  // namespace

Eigen::VectorXd start_of(const LifeDesign& design) {
  constexpr double kSmallestSpread = 0.01;
  const NormalEquations equations = normal_equations(design);
  const Eigen::VectorXd scale = equations.solve();
  const double rest =
      equations.squares - 2 * scale.dot(equations.right) + scale.dot(equations.matrix * scale);
  const double spread = std::max(kSmallestSpread, std::sqrt(std::max(0.0, rest / equations.count)));
  // ln of a Weibull life has the standard deviation pi / (sqrt(6) beta), and the mean ln alpha less
  // Euler's constant over beta.
  const double shape = std::numbers::pi / (std::sqrt(6.0) * spread);

  Eigen::VectorXd start(design.coefficients());
  start.head(design.scale_coefficients) =
      scale + std::numbers::egamma / shape * design.scale_of_one;
  start.tail(design.shape_coefficients) = std::log(shape) * design.shape_of_one;
  return start;
}

}  // namespace host_sim::life_law
