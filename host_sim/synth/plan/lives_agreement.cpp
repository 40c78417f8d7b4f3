#include <fmt/format.h>

#include <numbers>

#include "host_sim/reference/equations.hpp"
#include "host_sim/synth/plan/agreement.hpp"

namespace host_sim::synth {
namespace {

constexpr double kLeast_N = 0.01;

}  // namespace

void check_lives(const TomlTable& top, const SynthPlan& plan) {
  const TomlTable table = top.table("lives");
  if (!plan.cable || !plan.sheath || !plan.life) {
    fail_for_model(top, !plan.cable ? "cable" : !plan.sheath ? "sheath" : "life", "[lives]");
  }
  for (const LifeLevel& level : plan.lives->levels) {
    const LifeLoad& load = level.load;
    const double efficiency = reference::capstan_efficiency(
        plan.sheath->friction_coefficient, load.bend_angle_deg * std::numbers::pi / 180);
    const double input_maximum_N = (load.output_mean_N + load.output_amplitude_N) / efficiency;
    if (load.output_amplitude_N > load.output_mean_N || load.output_amplitude_N < kLeast_N ||
        !(input_maximum_N < plan.cable->ultimate_tension_N)) {
      table.fail(table.place_of("level"),
                 fmt::format("a level of {} +- {} N at {} deg", level.load.output_mean_N,
                             level.load.output_amplitude_N, level.load.bend_angle_deg),
                 "an amplitude up to the mean, and an input tension below the ultimate one");
    }
  }
}

}  // namespace host_sim::synth
