#include <algorithm>
#include <optional>
#include <tuple>

#include "host_sim/campaign/campaign.hpp"

namespace host_sim {
namespace {

/// Bend angles are not negative: without one comes before all.
double bend_angle_deg(const Campaign::Load& load) {
  return load.bend_angle_deg ? *load.bend_angle_deg : -1.0;
}

auto rank(const Level& level) {
  return std::tuple(level.load.effective_tension_N, level.role, bend_angle_deg(level.load),
                    level.load.input_tension_mean_N, level.load.input_tension_amplitude_N);
}

}  // namespace

std::vector<Level> levels_of(const Campaign& campaign) {
  std::vector<Level> single;
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (specimen.constant_load()) {
      single.push_back({specimen.blocks.front().load, specimen.role, {&specimen}});
    }
  }
  std::stable_sort(single.begin(), single.end(),
                   [](const Level& a, const Level& b) { return rank(a) < rank(b); });
  std::vector<Level> levels;
  for (const Level& one : single) {
    if (levels.empty() || rank(levels.back()) != rank(one)) {
      levels.push_back(one);
    } else {
      levels.back().specimens.push_back(one.specimens.front());
    }
  }
  return levels;
}

}  // namespace host_sim
