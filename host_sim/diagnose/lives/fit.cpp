#include "host_sim/diagnose/lives/fit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/diagnose/lives/likelihood.hpp"
#include "host_sim/diagnose/lives/maximize.hpp"
#include "host_sim/diagnose/lives/specimen_life.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// ln of half a standard normal density and half of one that is four times as wide, less that of
/// the first at 0.
double log_mixture(double u) {
  constexpr double kWide = 4;
  return log_sum(-u * u / 2, -u * u / (2 * kWide * kWide) - std::log(kWide)) - std::log(2);
}

/// Curvature below that of the widest prior comes of the approximation.
constexpr double kLeastCurvature = 0.05;

}  // namespace

life_law::LifeData life_data_of(const LifeSample& sample) {
  life_law::LifeData data;
  data.reserve(sample.size());
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    life_law::LifeDatum datum;
    for (const LifeSample::Block& block : specimen.blocks) {
      datum.blocks.push_back({block.effective_N, block.cycles});
    }
    datum.failed = specimen.failed;
    if (specimen.load != LifeSample::kNoLoad) {
      datum.level = specimen.load;
    }
    data.push_back(std::move(datum));
  }
  return data;
}

NominalFit fit_nominal(const LifeSample& sample) {
  const life_law::LifeFit fit = life_law::fit_life(life_data_of(sample));
  if (fit.problem != statistics::FitProblem::none) {
    return {.problem = fit.problem};
  }
  const life_law::LifeLaw law = fit.law();
  const double centre = centre_ln_N(sample, LifeSettings{});
  return {.centre_ln_N = centre,
          .ln_life_at_centre = std::log(law.scale) - law.exponent * centre,
          .exponent = law.exponent,
          .shape = law.shape,
          .log_likelihood = fit.log_likelihood};
}

double CommonPrior::log_density(double u_exponent, double u_shape) {
  return log_mixture(u_exponent) + log_mixture(u_shape);
}

ModelView::ModelView(const LifeSample& sample, const CommonPrior& prior,
                     std::span<const Term> terms)
    : sample_(sample), prior_(prior), terms_(terms), coordinates_(CommonPrior::kCount) {
  for (const Term& term : terms_) {
    firsts_.push_back(coordinates_);
    coordinates_ += static_cast<Eigen::Index>(term.parameters.size());
  }
}

std::vector<double> ModelView::values(const Eigen::VectorXd& at, std::size_t term) const {
  std::vector<double> values;
  Eigen::Index next = firsts_[term];
  for (const TermParameter& parameter : terms_[term].parameters) {
    values.push_back(parameter.value(at[next++]));
  }
  return values;
}

LifeSettings ModelView::settings(const Eigen::VectorXd& at) const {
  LifeSettings settings;
  settings.ln_life_at_centre = prior_.ln_life_at_centre + CommonPrior::kLife_sd * at[0];
  settings.exponent = std::exp(prior_.ln_exponent + CommonPrior::kLogExponent_sd * at[1]);
  settings.shape = std::exp(prior_.ln_shape + CommonPrior::kLogShape_sd * at[2]);
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    terms_[i].apply(values(at, i), settings);
  }
  return settings;
}

double ModelView::log_prior(const Eigen::VectorXd& at) const {
  return CommonPrior::log_density(at[1], at[2]) - at[0] * at[0] / 2 -
         at.tail(at.size() - CommonPrior::kCount).squaredNorm() / 2;
}

double ModelView::log_posterior(const Eigen::VectorXd& at) const {
  constexpr double kNone = -1e10;
  constexpr double kOutside = 12;
  if (at.cwiseAbs().maxCoeff() > kOutside) {
    return kNone;
  }
  const double value = log_likelihood(sample_, settings(at)) + log_prior(at);
  return std::isfinite(value) ? value : kNone;
}

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
  fit.at = maximize(objective, from);
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
  fit.at = whole(maximize(objective, from));
  fit.log_posterior = view.log_posterior(fit.at);
  fit.log_likelihood = fit.log_posterior - view.log_prior(fit.at);
  return fit;
}

}  // namespace host_sim::diagnose::lives
