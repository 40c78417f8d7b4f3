#include "host_sim/life_law/life_fit.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "host_sim/life_law/coefficients.hpp"
#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/life_likelihood.hpp"
#include "host_sim/life_law/newton.hpp"
#include "host_sim/life_law/start.hpp"

namespace host_sim::life_law {
namespace {

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
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(bend, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() > kFlattest;
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

Maximum climb_from(const LifeDesign& design, const Eigen::VectorXd& start) {
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
  const Maximum maximum = climb_from(design, start);
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

}  // namespace host_sim::life_law
