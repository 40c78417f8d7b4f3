#include "host_sim/diagnose/lives/fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/lives/climb.hpp"
#include "host_sim/diagnose/lives/nominal.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// Curvature below that of the widest prior comes of the approximation.
constexpr double kLeastCurvature = 0.05;

}  // namespace

CommonPrior common_prior(const LifeSample& sample) {
  const NominalFit fit = fit_nominal(sample);
  const double exponent = sample.nominal ? sample.nominal->ipl_exponent : fit.exponent;
  const double shape = sample.nominal ? sample.nominal->weibull_shape : fit.shape;
  return {.ln_life_at_centre = fit.ln_life_at_centre,
          .ln_exponent = std::log(std::clamp(exponent, 0.2, 40.0)),
          .ln_shape = std::log(std::clamp(shape, 0.3, 50.0))};
}

ModelFit fit_model(const ModelView& view, const Eigen::VectorXd& start) {
  const auto objective = [&](const Eigen::VectorXd& at) { return view.log_posterior(at); };
  const Eigen::VectorXd from =
      start.size() == 0 ? Eigen::VectorXd::Zero(view.coordinates()) : start;
  ModelFit fit;
  fit.at = climb(objective, from);
  fit.log_posterior = objective(fit.at);
  fit.log_likelihood = fit.log_posterior - view.log_prior(fit.at);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> curvature(-hessian(objective, fit.at));
  const Eigen::VectorXd sizes = curvature.eigenvalues().cwiseMax(kLeastCurvature);
  const auto& vectors = curvature.eigenvectors();
  fit.covariance = vectors * sizes.cwiseInverse().asDiagonal() * vectors.transpose();
  // (2 pi)^(n/2) of the integral and of the prior cancel.
  fit.log_evidence = fit.log_posterior - sizes.array().log().sum() / 2;
  return fit;
}

ModelFit fit_with_fixed(const ModelView& view, Eigen::Index fixed, double value,
                        const Eigen::VectorXd& start) {
  const Eigen::Index free = view.coordinates() - 1;
  const auto whole = [&](const Eigen::VectorXd& part) {
    Eigen::VectorXd at(view.coordinates());
    at << part.head(fixed), value, part.tail(free - fixed);
    return at;
  };
  const auto objective = [&](const Eigen::VectorXd& part) {
    return view.log_posterior(whole(part));
  };
  Eigen::VectorXd from(free);
  from << start.head(fixed), start.tail(free - fixed);
  ModelFit fit;
  fit.at = whole(climb(objective, from));
  fit.log_posterior = view.log_posterior(fit.at);
  fit.log_likelihood = fit.log_posterior - view.log_prior(fit.at);
  return fit;
}

}  // namespace host_sim::diagnose::lives
