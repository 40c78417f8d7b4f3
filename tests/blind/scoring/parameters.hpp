#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// A parameter of the catalogue with its true value.
struct TrueParameter {
  std::string name;
  double value = 0;
};

/// What the hidden effect means in parameters of the catalogue, those alone that mean the same in
/// the simulation: none for an effect that the catalogue has in another form.
std::vector<TrueParameter> true_parameters(const HiddenEffect& effect);

/// One estimate against the truth.
struct ParameterScore {
  double relative_error = 0;  ///< |estimate - truth| / |truth|
  bool covered = false;       ///< by the 95 % interval
};

/// Of those parameters that the effect was found with.
std::vector<ParameterScore> score_parameters(const std::vector<TrueParameter>& truth,
                                             const host_sim::diagnose::FoundEffect& found);

}  // namespace blind
