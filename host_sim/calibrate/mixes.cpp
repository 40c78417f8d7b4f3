#include "host_sim/calibrate/mixes.hpp"

#include <utility>

#include "host_sim/reference/life.hpp"

namespace host_sim::calibrate {

MixResult mix(std::string name, std::vector<MixResult::Part> parts, double ipl_exponent) {
  std::vector<reference::TensionShare> shares;
  shares.reserve(parts.size());
  for (const MixResult::Part& part : parts) {
    shares.push_back({part.effective_tension_N, part.share});
  }
  MixResult result;
  result.name = std::move(name);
  result.parts = std::move(parts);
  result.by_damage_N = reference::mix_by_damage(shares, ipl_exponent);
  result.by_average_of_lives_N = reference::mix_by_life(shares, ipl_exponent);
  return result;
}

std::vector<MixResult> mixes(const Campaign& campaign, const LifeLaw& law) {
  std::vector<MixResult> found;
  for (const Campaign::Use& use : campaign.uses) {
    if (use.parts.size() > 1) {
      std::vector<MixResult::Part> parts;
      for (const Campaign::Use::Part& part : use.parts) {
        parts.push_back({part.load.effective_tension_N, part.share});
      }
      found.push_back(mix(use.name, std::move(parts), law.exponent));
    }
  }
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (!specimen.constant_load()) {
      std::vector<MixResult::Part> parts;
      for (const Campaign::Block& block : specimen.blocks) {
        parts.push_back({block.load.effective_tension_N, block.cycles / specimen.cycles()});
      }
      found.push_back(mix(specimen.name, std::move(parts), law.exponent));
    }
  }
  return found;
}

}  // namespace host_sim::calibrate
