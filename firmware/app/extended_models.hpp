#pragma once

#include <array>
#include <cstddef>

#include "firmware/app/stored_parameters.hpp"
#include "lifemodel/block/extended_block.hpp"

namespace app {

/// What the sensors of all tendons are to evaluate: the parameters in use, and the extension of
/// `configured` where they are those that it came with. Parameters that were loaded under authority
/// are those of another model and have no extension.
template <std::size_t kTendons>
std::array<lifemodel::ExtendedParameters, kTendons> extended_models(
    const ParameterSet<kTendons>& in_use, const lifemodel::ExtendedParameters& configured) {
  std::array<lifemodel::ExtendedParameters, kTendons> models{};
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    if (in_use[tendon]) {
      models[tendon].nominal = *in_use[tendon];
      if (in_use[tendon]->model_digest == configured.nominal.model_digest) {
        models[tendon].extension = configured.extension;
      }
    }
  }
  return models;
}

}  // namespace app
