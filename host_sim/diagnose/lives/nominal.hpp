#pragma once

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/life_law/life_fit.hpp"

namespace host_sim::diagnose::lives {

/// The sample as the inverse power law with one shape sees it. Specimens of one load have its
/// number as their level.
life_law::LifeData life_data_of(const LifeSample& sample);

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

}  // namespace host_sim::diagnose::lives
