#pragma once

#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/judgement.hpp"

namespace host_sim::diagnose {

/// Sets of effects that may be all that is wrong, by the inclusion probability of each effect of a
/// model, of what could be in its place, and of neither where it may not be named; the most
/// probable first.
/// @param left_out what may be there besides, though the model does without
/// @param rest what is there if no set is: "none" or "unknown"
/// @param remainder_stands whether what is left is no chance: each set is there with `rest`, too
std::vector<Candidate> candidates_of(const ForceData& data, std::span<const Judged> judged,
                                     std::span<const LeftOut> left_out, const std::string& rest,
                                     bool remainder_stands);

}  // namespace host_sim::diagnose
