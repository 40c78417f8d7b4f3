#include "host_sim/calibrate/specimens.hpp"

namespace host_sim::calibrate {
namespace {

life_law::LifeDatum datum_of(const Campaign::Specimen& specimen, std::size_t level) {
  life_law::LifeDatum datum;
  for (const Campaign::Block& block : specimen.blocks) {
    datum.blocks.push_back({block.load.effective_tension_N, block.cycles});
  }
  datum.failed = specimen.status == Campaign::Status::failed;
  datum.level = level;
  return datum;
}

life_law::LifeData in_blocks(const Campaign& campaign, Campaign::Role role) {
  life_law::LifeData data;
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (specimen.role == role && !specimen.constant_load()) {
      data.push_back(datum_of(specimen, life_law::LifeDatum::kNoLevel));
    }
  }
  return data;
}

}  // namespace

life_law::LifeData specimens_to_fit(const Campaign& campaign, std::span<const LevelResult> levels,
                                    std::span<const Level> sources) {
  life_law::LifeData data = in_blocks(campaign, Campaign::Role::fit);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].role != Campaign::Role::fit || !levels[i].left_out.empty()) {
      continue;
    }
    const life_law::LifeData level = level_specimens(sources[i], i);
    data.insert(data.end(), level.begin(), level.end());
  }
  return data;
}

life_law::LifeData level_specimens(const Level& level, std::size_t number) {
  life_law::LifeData data;
  for (const Campaign::Specimen* specimen : level.specimens) {
    data.push_back(datum_of(*specimen, number));
  }
  return data;
}

life_law::LifeData validation_in_blocks(const Campaign& campaign) {
  return in_blocks(campaign, Campaign::Role::validation);
}

}  // namespace host_sim::calibrate
