#pragma once

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/fit.hpp"

namespace host_sim::diagnose::lives {

/// What a model predicts of specimens that it was not fitted to, against the nominal law: levels
/// are held out one after the other where there are four or more, else every fifth specimen.
/// log_predictive_density is the mean of the censored Weibull score of a specimen; b10_coverage is
/// the share that failed before B10 of those for which that is known.
Gain gain_of(const LifeSample& sample, const Model& model, const ModelFit& fit, unsigned threads);

}  // namespace host_sim::diagnose::lives
