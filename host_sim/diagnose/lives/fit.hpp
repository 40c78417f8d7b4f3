#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/diagnose/lives/terms.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::diagnose::lives {

/// The sample as the inverse power law with one shape sees it. Specimens of one load have its
/// number as their level. Lives at one level alone are taken to the tension at the centre, by gamma
/// of the campaign's model.
life_law::LifeData life_data_of(const LifeSample& sample);

/// The law of maximum likelihood, as it is fitted to life_data_of() a sample.
class LawOfSample {
 public:
  explicit LawOfSample(const LifeSample& sample);

  [[nodiscard]] life_law::LifeFit fit(const life_law::LifeData& data) const;
  /// @pre without problem
  [[nodiscard]] life_law::LifeLaw law(const life_law::LifeFit& fit) const;

 private:
  bool one_level_;
  double centre_ln_N_;
  double model_exponent_ = 0;  ///< of the campaign's model, where there is one level
};

/// The law that every other is compared with, by maximum likelihood.
struct NominalFit {
  double centre_ln_N = 0;        ///< centre_ln_N() of neutral settings
  double ln_life_at_centre = 0;  ///< ln alpha there
  double exponent = 0;
  double shape = 0;
  double log_likelihood = 0;
  statistics::FitProblem problem = statistics::FitProblem::none;
};
NominalFit fit_nominal(const LifeSample& sample);

/// Where the parameters that every model has are looked for. ln alpha at the centre is normal about
/// the fit of the nominal law, wide against what a campaign says. ln gamma and ln beta are normal
/// about the values of the campaign's model or, as probably, four times as wide: a model that is
/// about right says more of an effect than one that is anybody's guess, which is let go of. Where
/// the campaign has no model they are as wide as the published laws of metals are apart.
struct CommonPrior {
  double ln_life_at_centre = 0;
  double ln_exponent = 0;
  double ln_shape = 0;
  bool modelled = true;  ///< the campaign has a model of its lives
  /// Coordinates of the nominal law of maximum likelihood.
  Eigen::Vector3d nominal = Eigen::Vector3d::Zero();

  static constexpr Eigen::Index kCount = 3;
  static constexpr double kLife_sd = 1, kLogExponent_sd = 0.2, kLogShape_sd = 0.25;

  /// ln of the prior of the two, less that of standard normal densities at 0.
  [[nodiscard]] double log_density(double u_exponent, double u_shape) const;
};

/// @pre two failures or more at two levels or more
CommonPrior common_prior(const LifeSample& sample);

using Model = std::vector<Term>;  ///< with the nominal law; none is the nominal law alone

/// Coordinates of a model: three common ones, see CommonPrior, then those of its terms with
/// standard normal priors.
class ModelView {
 public:
  ModelView(const LifeSample& sample, const CommonPrior& prior, std::span<const Term> terms);

  [[nodiscard]] Eigen::Index coordinates() const { return coordinates_; }
  [[nodiscard]] LifeSettings settings(const Eigen::VectorXd& at) const;
  /// Of one term, in order of its parameters.
  [[nodiscard]] std::vector<double> values(const Eigen::VectorXd& at, std::size_t term) const;
  [[nodiscard]] Eigen::Index first(std::size_t term) const { return firsts_[term]; }
  [[nodiscard]] std::span<const Term> terms() const { return terms_; }
  [[nodiscard]] const LifeSample& sample() const { return sample_; }
  [[nodiscard]] const CommonPrior& prior() const { return prior_; }
  [[nodiscard]] double log_prior(const Eigen::VectorXd& at) const;  ///< but for a constant
  /// Log likelihood and log prior; -1e10 where there is no likelihood.
  [[nodiscard]] double log_posterior(const Eigen::VectorXd& at) const;

 private:
  const LifeSample& sample_;
  CommonPrior prior_;
  std::span<const Term> terms_;
  std::vector<Eigen::Index> firsts_;
  Eigen::Index coordinates_ = 0;
};

/// The most probable parameters of a model, and how probable the lives are under it.
struct ModelFit {
  Eigen::VectorXd at;
  Eigen::MatrixXd covariance;  ///< of the coordinates, by the curvature there
  double log_posterior = 0;
  double log_likelihood = 0;
  double log_evidence = 0;  ///< by Laplace's approximation
};

/// Climbs from the first of `starts`, zeros where there are none, that is not hopeless: behind them
/// come the same with the nominal law of maximum likelihood, because lives are so improbable under
/// a campaign's model that is far off that no slope leads away.
ModelFit fit_model(const ModelView& view, const std::vector<Eigen::VectorXd>& starts = {});

/// The same with one coordinate held at a value; covariance and evidence are not computed.
ModelFit fit_with_fixed(const ModelView& view, Eigen::Index fixed, double value,
                        const Eigen::VectorXd& start);

}  // namespace host_sim::diagnose::lives
