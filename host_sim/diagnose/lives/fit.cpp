#include "host_sim/diagnose/lives/fit.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/diagnose/lives/likelihood.hpp"
#include "host_sim/diagnose/lives/maximize.hpp"
#include "host_sim/diagnose/lives/specimen_life.hpp"
#include "host_sim/statistics/eigen_system.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// ln of a normal density that is wider than the standard one, less that of the standard one at 0.
double log_wide(double u, double sd) {
  return -u * u / (2 * sd * sd) - std::log(sd);
}

/// Of half a standard normal density and half of one that is four times as wide.
double log_mixture(double u) {
  constexpr double kWide = 4;
  return log_sum(log_wide(u, 1), log_wide(u, kWide)) - std::log(2);
}

/// Where the nominal law of maximum likelihood is looked for from.
constexpr double kFarthestNominal = 0.8 * kFarthest;

Eigen::VectorXd with_nominal(Eigen::VectorXd at, const CommonPrior& prior) {
  at.head<CommonPrior::kCount>() = prior.nominal;
  return at;
}

/// The first that is not hopeless against the others: a hill that is higher where the climb begins
/// need not be the highest.
Eigen::VectorXd start_of(const ModelView& view, std::vector<Eigen::VectorXd> starts) {
  if (starts.empty()) {
    starts.emplace_back(Eigen::VectorXd::Zero(view.coordinates()));
  }
  const std::size_t given = starts.size();
  for (std::size_t i = 0; i < given; ++i) {
    starts.push_back(with_nominal(starts[i], view.prior()));
  }
  std::vector<double> values;
  values.reserve(starts.size());
  for (const Eigen::VectorXd& start : starts) {
    values.push_back(view.log_posterior(start));
  }
  constexpr double kHopeless = 100;
  const double least = std::ranges::max(values) - kHopeless;
  const auto first = std::ranges::find_if(values, [=](double value) { return value >= least; });
  return starts[static_cast<std::size_t>(first - values.begin())];
}

/// Curvature below that of the widest prior comes of the approximation.
constexpr double kLeastCurvature = 0.05;

}  // namespace

life_law::LifeData life_data_of(const LifeSample& sample) {
  life_law::LifeData data;
  if (sample.levels == 1 && sample.nominal) {
    const double centre_N = std::exp(centre_ln_N(sample, LifeSettings{}));
    for (const LifeSample::Specimen& specimen : sample.specimens) {
      double cycles = 0;
      for (const LifeSample::Block& block : specimen.blocks) {
        cycles +=
            block.cycles * std::pow(block.effective_N / centre_N, sample.nominal->ipl_exponent);
      }
      data.push_back({.blocks = {{centre_N, cycles}}, .failed = specimen.failed, .level = 0});
    }
    return data;
  }
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

LawOfSample::LawOfSample(const LifeSample& sample)
    : one_level_(sample.levels == 1 && sample.nominal),
      centre_ln_N_(centre_ln_N(sample, LifeSettings{})) {
  if (one_level_) {
    model_exponent_ = sample.nominal->ipl_exponent;
  }
}

life_law::LifeFit LawOfSample::fit(const life_law::LifeData& data) const {
  return life_law::fit_life(data, {.scale = one_level_ ? life_law::LifeForm::Scale::free
                                                       : life_law::LifeForm::Scale::power_law});
}

life_law::LifeLaw LawOfSample::law(const life_law::LifeFit& fit) const {
  return one_level_
             ? life_law::LifeLaw{.scale = std::exp(fit.scale[0] + model_exponent_ * centre_ln_N_),
                                 .exponent = model_exponent_,
                                 .shape = std::exp(fit.shape[0])}
             : fit.law();
}

NominalFit fit_nominal(const LifeSample& sample) {
  const LawOfSample of_sample(sample);
  const life_law::LifeFit fit = of_sample.fit(life_data_of(sample));
  if (fit.problem != statistics::FitProblem::none) {
    return {.problem = fit.problem};
  }
  const life_law::LifeLaw law = of_sample.law(fit);
  const double centre = centre_ln_N(sample, LifeSettings{});
  return {.centre_ln_N = centre,
          .ln_life_at_centre = std::log(law.scale) - law.exponent * centre,
          .exponent = law.exponent,
          .shape = law.shape,
          .log_likelihood = fit.log_likelihood};
}

double CommonPrior::log_density(double u_exponent, double u_shape) const {
  constexpr double kLogExponentUnknown_sd = 1 / kLogExponent_sd;
  constexpr double kLogShapeUnknown_sd = 1 / kLogShape_sd;
  return modelled ? log_mixture(u_exponent) + log_mixture(u_shape)
                  : log_wide(u_exponent, kLogExponentUnknown_sd) +
                        log_wide(u_shape, kLogShapeUnknown_sd);
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
  return prior_.log_density(at[1], at[2]) - at[0] * at[0] / 2 -
         at.tail(at.size() - CommonPrior::kCount).squaredNorm() / 2;
}

double ModelView::log_posterior(const Eigen::VectorXd& at) const {
  constexpr double kNone = -1e10;
  constexpr double kOutside = kFarthest + 1;
  if (at.cwiseAbs().maxCoeff() > kOutside) {
    return kNone;
  }
  const double value = log_likelihood(sample_, settings(at)) + log_prior(at);
  return std::isfinite(value) ? value : kNone;
}

CommonPrior common_prior(const LifeSample& sample) {
  constexpr double kUsualExponent = 6;
  constexpr double kUsualShape = 3;
  const NominalFit fit = fit_nominal(sample);
  CommonPrior prior{.ln_life_at_centre = fit.ln_life_at_centre,
                    .ln_exponent = std::log(kUsualExponent),
                    .ln_shape = std::log(kUsualShape),
                    .modelled = sample.nominal.has_value()};
  if (prior.modelled) {
    prior.ln_exponent = std::log(std::clamp(sample.nominal->ipl_exponent, 0.2, 40.0));
    prior.ln_shape = std::log(std::clamp(sample.nominal->weibull_shape, 0.3, 50.0));
  }
  if (fit.exponent > 0 && fit.shape > 0) {
    prior.nominal = {0, (std::log(fit.exponent) - prior.ln_exponent) / CommonPrior::kLogExponent_sd,
                     (std::log(fit.shape) - prior.ln_shape) / CommonPrior::kLogShape_sd};
    prior.nominal = prior.nominal.cwiseMax(-kFarthestNominal).cwiseMin(kFarthestNominal);
  }
  return prior;
}

ModelFit fit_model(const ModelView& view, const std::vector<Eigen::VectorXd>& starts) {
  const auto objective = [&](const Eigen::VectorXd& at) { return view.log_posterior(at); };
  ModelFit fit;
  fit.at = maximize(objective, start_of(view, starts));
  fit.log_posterior = objective(fit.at);
  fit.log_likelihood = fit.log_posterior - view.log_prior(fit.at);
  const auto [values, vectors] = statistics::eigen_system(-hessian(objective, fit.at));
  const Eigen::VectorXd sizes = values.cwiseMax(kLeastCurvature);
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
