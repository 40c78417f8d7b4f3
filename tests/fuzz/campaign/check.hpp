#pragma once

#include <cmath>
#include <set>
#include <string>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/campaign/load.hpp"
#include "tests/fuzz/io/require.hpp"

namespace host_sim::fuzz {

/// The wire of the paper.
inline CampaignFile paper_campaign() {
  return parse_campaign_file(
      "[campaign]\nname = 'paper'\n"
      "[model.cable]\ndiameter_mm = 0.457\nultimate_tension_N = 177.4\n"
      "[model.sheath]\nfriction_coefficient = 0.128\nbend_angle_deg = 270\n",
      "paper");
}

inline void check(const Campaign::Load& load) {
  require(load.input_tension_mean_N >= 0);
  require(load.input_tension_amplitude_N > 0);
  require(load.effective_tension_N >= LoadModel::kLeastTension_N);
  require(std::isfinite(load.effective_tension_N));
}

inline void check(const Campaign& campaign) {
  std::set<std::string> names;
  std::size_t constant = 0;
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    require(names.insert(specimen.name).second);
    require(!specimen.name.empty());
    require(!specimen.blocks.empty());
    require(specimen.cycles() > 0 && std::isfinite(specimen.cycles()));
    constant += specimen.constant_load() ? 1 : 0;
    for (const Campaign::Block& block : specimen.blocks) {
      require(block.cycles > 0);
      check(block.load);
    }
  }
  double last_N = 0;
  for (const Level& level : levels_of(campaign)) {
    require(level.load.effective_tension_N >= last_N);
    last_N = level.load.effective_tension_N;
    require(level.specimens.size() <= constant);
    constant -= level.specimens.size();
  }
  require(constant == 0);
}

}  // namespace host_sim::fuzz
