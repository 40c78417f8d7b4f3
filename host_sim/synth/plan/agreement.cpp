#include "host_sim/synth/plan/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host_sim/synth/plan/tables.hpp"

namespace host_sim::synth {
namespace {

constexpr std::array<std::string_view, 5> kOfDrive{
    "current_offset", "torque_gain", "gear_asymmetry", "torque_ripple", "rotor_inertia"};
void check_hidden(const TomlTable& top, const SynthPlan& plan, const Hidden& hidden) {
  const std::string_view above = hidden.outside ? "outside" : "effects";
  const TomlTable table = top.table(above).table(hidden.id);
  const auto needs = [&](bool given, std::string_view what) {
    if (!given) {
      table.fail(table.place(), fmt::format("[{}.{}] without {}", above, hidden.id, what),
                 fmt::format("{}, which it needs", what));
    }
  };
  needs(hidden.of_life ? plan.lives.has_value() : plan.recordings.has_value(),
        hidden.of_life ? "[lives]" : "[recordings]");
  if (std::find(kOfDrive.begin(), kOfDrive.end(), hidden.id) != kOfDrive.end()) {
    needs(plan.drive.has_value(), "[model.drive]");
  }
  if (hidden.id == "load_cell_cross_talk") {
    needs(plan.recordings->motion.pose_sway_deg > 0, "pose_sway_deg above 0 in [recordings]");
  }
  if (hidden.id == "rig_bias") {
    needs(plan.lives->rigs > 1, "rigs above 1 in [lives]");
  }
  if (hidden.id == "bending_fatigue") {
    const auto& levels = plan.lives->levels;
    needs(std::all_of(levels.begin(), levels.end(),
                      [](const LifeLevel& level) { return level.load.wire_to_bend_ratio > 0; }),
          "wire_to_bend_ratio in each [[lives.level]]");
  }
}

}  // namespace

[[noreturn]] void fail_for_model(const TomlTable& top, std::string_view table,
                                 std::string_view why) {
  top.fail(top.place_of("model"), fmt::format("no table [model.{}]", table),
           fmt::format("[model.{}], which {} needs", table, why));
}

void check_agreement(const TomlTable& top, const SynthPlan& plan) {
  if (!plan.recordings && !plan.lives) {
    top.fail({}, "neither recordings nor lives", "a table [recordings], [lives] or both");
  }
  if (plan.recordings) {
    check_recordings(top, plan);
  }
  if (plan.lives) {
    check_lives(top, plan);
  }
  for (const Hidden& hidden : plan.hidden) {
    check_hidden(top, plan, hidden);
  }
}

}  // namespace host_sim::synth
