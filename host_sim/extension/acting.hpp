#pragma once

#include <string>
#include <vector>

#include "hal/files/profile.hpp"
#include "hal/files/profile_columns.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// An effect of a model that is not evaluated.
struct NotEvaluated {
  std::string id;
  std::string why;  ///< "needs sheath_temperature_C"
};

/// Which extensions of a model change the input tension or the damage on line.
struct Acting {
  std::vector<Extension> extensions;  ///< that do
  std::vector<NotEvaluated> others;   ///< that do not; none is left out of both
};

/// Of a model whose input is of this kind, with these channels beside it. What friction does
/// between motor and output is not seen in a motor current, and what drive and current sensor do
/// not in an output tension.
Acting acting_extensions(const Model& model, hal::files::InputKind kind,
                         const hal::files::ProfileChannels& channels);

}  // namespace host_sim
