#pragma once

#include <string>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/fit.hpp"

namespace host_sim::diagnose::lives {

/// What a model predicts of specimens that it was not fitted to, against the nominal law: levels
/// are held out one after the other where there are four or more, else every fifth specimen.
/// log_predictive_density is the mean of the censored Weibull score of a specimen; b10_coverage is
/// the share that failed before B10 of those for which that is known.
HeldOutGain gain_of(const LifeSample& sample, const Model& model, const ModelFit& fit,
                    unsigned threads);

/// Validation specimens of one load against a law. Normal approximation of ln of the mean life of n
/// specimens, its variance (Gamma(1 + 2/beta) / Gamma(1 + 1/beta)^2 - 1) / n, together with that
/// of the law as it was fitted.
struct ValidationPower {
  std::size_t specimens = 0;
  double ln_deviation = 0;  ///< ln of the measured mean life over that of the law
  double ln_sd = 0;         ///< of one specimen
  double ln_sd_of_law = 0;

  /// Two-sided p of no deviation.
  [[nodiscard]] double p() const;
  /// Specimens with which a deviation as large as this one is found at 5 % in 80 % of campaigns;
  /// 0 where not even any number would do, for the uncertainty of the law.
  [[nodiscard]] std::size_t specimens_needed() const;
};

/// A sentence for each load that was validated with failures alone; empty where there is none.
std::string validation_prose(const Campaign& campaign, const ModelView& view, const ModelFit& fit);

}  // namespace host_sim::diagnose::lives
