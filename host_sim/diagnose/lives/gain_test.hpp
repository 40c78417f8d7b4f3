#pragma once

#include <cstdint>

#include "host_sim/diagnose/lives/fit.hpp"

namespace host_sim::diagnose::lives {

struct GainTestOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;
  std::size_t replicates = 99;
};

/// How seldom lives of the nominal law gain as much log posterior by a model as these do: p by the
/// parametric bootstrap, the nominal law and the model fitted to each replicate. It sees what no
/// covariate shows, as specimens that fail at a load or never do.
/// @param nominal, fit of the sample, by the nominal law and by `model`
double gain_p(const LifeSample& sample, const CommonPrior& prior, const Model& model,
              const ModelFit& nominal, const ModelFit& fit, const GainTestOptions& options);

}  // namespace host_sim::diagnose::lives
