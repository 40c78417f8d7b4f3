#include "host_sim/synth/campaign/tension_parts.hpp"

#include <algorithm>

#include "host_sim/synth/tension/catalogue.hpp"

namespace host_sim::synth {
namespace {

std::unique_ptr<TensionPart> make_part(const Hidden& hidden) {
  const auto kinds = hidden.outside ? outside_tension_kinds() : tension_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const TensionKind& candidate) {
    return candidate.id == hidden.id;
  });
  return kind->make(hidden.values);
}

}  // namespace

std::vector<std::unique_ptr<TensionPart>> tension_parts(const SynthPlan& plan,
                                                        const Setting& setting, std::uint64_t seed,
                                                        std::string_view only) {
  std::vector<std::unique_ptr<TensionPart>> parts;
  for (const Hidden& hidden : plan.hidden) {
    if (!hidden.of_life && (only.empty() || only == hidden.id)) {
      parts.push_back(make_part(hidden));
      parts.back()->begin(setting, seed);
    }
  }
  return parts;
}

}  // namespace host_sim::synth
