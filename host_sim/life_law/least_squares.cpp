#include <Eigen/Core>
#include <cmath>

#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/newton.hpp"

namespace host_sim::life_law {
namespace {

/// Minus half the sum of squares of the errors of exp(a - g x) against lives, and its derivatives
/// with respect to (a, g).
class SumOfSquares {
 public:
  SumOfSquares(const Eigen::VectorXd& x, const Eigen::VectorXd& lives) : x_(x), lives_(lives) {}

  void operator()(const Eigen::VectorXd& at, Expansion& expansion) const {
    expansion.reset(2);
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      const Eigen::Vector2d row(1, -x_[j]);
      const double life = std::exp(row.dot(at));
      const double error = lives_[j] - life;
      expansion.value -= error * error / 2;
      expansion.gradient += error * life * row;
      expansion.hessian += (error - life) * life * row * row.transpose();
    }
  }

 private:
  const Eigen::VectorXd& x_;
  const Eigen::VectorXd& lives_;
};

/// The straight line through the logarithms.
Eigen::Vector2d line_through(const Eigen::VectorXd& x, const Eigen::VectorXd& lives) {
  const Eigen::VectorXd ln_lives = lives.array().log();
  return {ln_lives.mean(), -x.dot(ln_lives) / x.squaredNorm()};
}

}  // namespace

LeastSquares fit_least_squares(std::span<const double> effective_tension_N,
                               std::span<const double> characteristic_life) {
  const auto count = static_cast<Eigen::Index>(effective_tension_N.size());
  const Eigen::Map<const Eigen::VectorXd> tensions_N(effective_tension_N.data(), count);
  const Eigen::Map<const Eigen::VectorXd> alphas(characteristic_life.data(), count);
  const Eigen::VectorXd ln_tension = tensions_N.array().log();
  const double centre = ln_tension.mean();
  const double unit = alphas.mean();
  const Eigen::VectorXd x = ln_tension.array() - centre;
  const Eigen::VectorXd lives = alphas / unit;

  const Maximum maximum = maximise(SumOfSquares(x, lives), line_through(x, lives));
  const double exponent = maximum.at[1];
  return {
      .scale = unit * std::exp(maximum.at[0] + exponent * centre),
      .exponent = exponent,
      .rmse_cycles = unit * std::sqrt(-2 * maximum.expansion.value / static_cast<double>(count))};
}

}  // namespace host_sim::life_law
