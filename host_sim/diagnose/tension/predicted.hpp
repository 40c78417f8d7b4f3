#pragma once

#include <vector>

#include "host_sim/diagnose/tension/model_fit.hpp"

namespace host_sim::diagnose {

/// What a fitted model makes of one session, sample by sample.
struct Predicted {
  std::vector<double> output_N;  ///< from T_in as measured alone
  std::vector<double> input_N;   ///< from T_out as measured alone
};

/// @param layout of the model alone; `fit` has its coefficients in order of its columns
Predicted predict(const Session& session, const GramLayout& layout,
                  const effects::Baseline& baseline, const ModelFit& fit);

}  // namespace host_sim::diagnose
