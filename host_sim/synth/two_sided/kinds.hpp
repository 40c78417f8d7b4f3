#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "host_sim/synth/two_sided/drive.hpp"
#include "host_sim/synth/values.hpp"

namespace host_sim::synth {

/// A departure that a drive working in both directions may have.
struct TwoSidedKind {
  std::string_view id;
  std::vector<Parameter> parameters;
  std::vector<Choice> choices;
  void (*add)(const Values& values, TwoSidedEffects& effects);
};

/// Effects of the catalogue in order of its table, and departures that it does not have.
std::span<const TwoSidedKind> two_sided_kinds();
std::span<const TwoSidedKind> outside_two_sided_kinds();

}  // namespace host_sim::synth
