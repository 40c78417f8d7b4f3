#include "host_sim/life_law/life_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/life_likelihood.hpp"
#include "host_sim/life_law/newton.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/statistics/eigen_system.hpp"

namespace host_sim::life_law {

double LifeLaw::characteristic_life(double effective_tension_N) const {
  return reference::ipl_life_cycles(effective_tension_N, scale, exponent);
}

double LifeLaw::mean_life(double effective_tension_N) const {
  return characteristic_life(effective_tension_N) * reference::weibull_mean_damage(shape);
}

double LifeLaw::quantile(double p, double effective_tension_N) const {
  return characteristic_life(effective_tension_N) * reference::weibull_life_damage(p, shape);
}

statistics::Observation LifeDatum::observation() const {
  return {
      .value = blocks.front().cycles, .failed = failed, .from = from_cycles, .trimmed = trimmed};
}

void LifeDatum::observe(const statistics::Observation& seen) {
  blocks.front().cycles = seen.value;
  failed = seen.failed;
  from_cycles = seen.from;
  trimmed = seen.trimmed;
}

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
      const double ln_cycles =
          std::isfinite(life.ln_from) ? (life.ln_from + life.ln_cycles) / 2 : life.ln_cycles;
      sum += ln_cycles;
      squares += ln_cycles * ln_cycles;
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

/// Coefficients to start from: least squares of ln cycles, as if the suspended had failed and what
/// was found broken had done so in the middle, with the
/// shape that belongs to the spread of what is left.
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

using statistics::FitProblem;

/// Shapes on the way to infinity are beyond this.
constexpr double kSteepLnShape = kLargestLnShape - 4;

/// Whether the likelihood bends down in every direction. Scale coefficients are measured in units
/// of 1 / shape and x is of order one, so that a failure bends by about one.
bool is_identified(const LifeDesign& design, const Maximum& maximum) {
  constexpr double kFlattest = 1e-8;
  const double shape =
      std::exp(design.shape_of_one.dot(maximum.at.tail(design.shape_coefficients)) /
               design.shape_of_one.squaredNorm());
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(design.coefficients());
  unit.head(design.scale_coefficients).setConstant(1 / shape);
  const Eigen::MatrixXd bend = unit.asDiagonal() * (-maximum.expansion.hessian) * unit.asDiagonal();
  return statistics::eigen_system(bend).values.minCoeff() > kFlattest;
}

FitProblem problem_of(const LifeDesign& design, const Maximum& maximum) {
  if (largest_ln_shape(design, maximum.at) > kSteepLnShape) {
    return FitProblem::no_spread;
  }
  if (!maximum.converged) {
    return FitProblem::not_converged;
  }
  return is_identified(design, maximum) ? FitProblem::none : FitProblem::not_identified;
}

Maximum maximize_from(const LifeDesign& design, const Eigen::VectorXd& start) {
  return maximise([&design](const Eigen::VectorXd& at,
                            Expansion& expansion) { expand_log_likelihood(design, at, expansion); },
                  start);
}

bool can_start_from(const LifeFit& fit) {
  return fit.problem == FitProblem::none && std::isfinite(fit.log_likelihood);
}

/// Fits a form, from a fit nearby where one is given.
LifeFit fit_form(std::span<const LifeDatum> data, LifeForm form, const LifeFit* nearby) {
  const LogTensionFrame frame = frame_of(data);
  const Participation participation(data, form);
  const LifeDesign design = design_of(data, form, frame, participation);
  LifeFit fit{.form = form, .scale = {}, .shape = {}};
  if (design.failures() < 2) {
    fit.problem = FitProblem::too_few_failures;
    return fit;
  }
  Eigen::VectorXd start = start_of(design);
  if (nearby != nullptr) {
    const Eigen::VectorXd near_start = design_coefficients(*nearby, frame, participation);
    if (near_start.allFinite()) {
      start = near_start;
    }
  }
  const Maximum maximum = maximize_from(design, start);
  set_coefficients(fit, maximum.at, frame, participation);
  fit.log_likelihood = maximum.expansion.value;
  fit.problem = problem_of(design, maximum);
  return fit;
}

}  // namespace

LifeLaw LifeFit::law() const {
  return {.scale = std::exp(scale[0] + scale[1] * centre_ln_N),
          .exponent = scale[1],
          .shape = std::exp(shape[0])};
}

LifeFit fit_life(std::span<const LifeDatum> data, LifeForm form) {
  return fit_form(data, form, nullptr);
}

LifeFit fit_life(std::span<const LifeDatum> data, const LifeFit& start) {
  if (can_start_from(start)) {
    LifeFit fit = fit_form(data, start.form, &start);
    if (fit.problem == FitProblem::none || fit.problem == FitProblem::too_few_failures) {
      return fit;
    }
  }
  return fit_form(data, start.form, nullptr);
}

double log_likelihood(std::span<const LifeDatum> data, const LifeFit& fit) {
  const LogTensionFrame frame{.centre = fit.centre_ln_N, .spread = 1};
  const Participation participation(fit);
  const LifeDesign design = design_of(data, fit.form, frame, participation);
  Expansion expansion;
  expand_log_likelihood(design, design_coefficients(fit, frame, participation), expansion);
  return expansion.value;
}

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
