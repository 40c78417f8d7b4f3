#include <cmath>

#include "host_sim/diagnose/lives/fit.hpp"
#include "host_sim/diagnose/lives/likelihood.hpp"
#include "host_sim/diagnose/lives/specimen_life.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// ln of half a standard normal density and half of one that is four times as wide, less that of
/// the first at 0.
double log_mixture(double u) {
  constexpr double kWide = 4;
  return log_sum(-u * u / 2, -u * u / (2 * kWide * kWide) - std::log(kWide)) - std::log(2);
}

}  // namespace

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
  constexpr double kFarthest = 12;
  if (at.cwiseAbs().maxCoeff() > kFarthest) {
    return kNone;
  }
  const double value = log_likelihood(sample_, settings(at)) + log_prior(at);
  return std::isfinite(value) ? value : kNone;
}

}  // namespace host_sim::diagnose::lives
