#pragma once

#include <cstdint>
#include <string>

#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose {

/// What a result says beside the diagnosis.
struct ResultsContext {
  std::string campaign;        ///< its name
  std::string extended_model;  ///< path of the model that was written; empty where none was
  std::uint64_t seed = 1;
};

/// The diagnosis as one JSON object with the fields of the file format: at the top those of
/// recordings and lives merged, then `tension` (of the recordings) and `lives` by themselves, null
/// where there are none. Intervals are [low, high], what is not finite is null.
/// @param indent spaces for each depth; negative: all on one line
std::string diagnosis_json(const Diagnosis& diagnosis, const ResultsContext& context,
                           int indent = 2);

}  // namespace host_sim::diagnose
