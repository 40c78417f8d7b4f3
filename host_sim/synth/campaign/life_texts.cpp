#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "host_sim/synth/campaign/lives.hpp"

namespace host_sim::synth {
namespace {

/// The columns of specimens.csv that not every campaign has.
struct Columns {
  bool days = false;
  bool wire_to_bend_ratio = false;
  bool group = false;
};

Columns columns_of(const LifePlan& plan) {
  const bool has_ratio =
      std::any_of(plan.levels.begin(), plan.levels.end(),
                  [](const LifeLevel& level) { return level.load.wire_to_bend_ratio > 0; });
  return {plan.record_days, has_ratio, plan.rigs > 1};
}

std::string load_text(const LifeLoad& load) {
  return fmt::format("{},{},{}", load.bend_angle_deg, load.output_mean_N, load.output_amplitude_N);
}

std::string name_of(const LifeSpecimen& specimen) {
  return fmt::format("w{:04}", specimen.place.number + 1);
}

void append_row(const LifePlan& plan, const LifeSpecimen& specimen, const Columns& columns,
                std::string& text) {
  const LifeLoad& load = plan.levels[specimen.levels.front()].load;
  const auto& cycles = specimen.result.cycles;
  const bool constant = specimen.levels.size() == 1;
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out, "{},lot{},{},{:.0f},{},{}", name_of(specimen), specimen.place.lot + 1,
      constant ? load_text(load) : ",,", std::accumulate(cycles.begin(), cycles.end(), 0.0),
      specimen.result.failed ? "failed" : "suspended", specimen.validation ? "validation" : "fit");
  if (columns.days) {
    fmt::format_to(out, ",{:.6f}", specimen.result.days);
  }
  if (columns.wire_to_bend_ratio) {
    text += ',';
    text += load.wire_to_bend_ratio > 0 ? fmt::format("{}", load.wire_to_bend_ratio) : "";
  }
  if (columns.group) {
    fmt::format_to(out, ",rig{}", specimen.place.rig + 1);
  }
  text += '\n';
}

void append_blocks(const LifePlan& plan, const LifeSpecimen& specimen, std::string& text) {
  const auto& cycles = specimen.result.cycles;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{:.0f}\n", name_of(specimen), i + 1,
                   load_text(plan.levels[specimen.levels[i]].load), cycles[i]);
  }
}

}  // namespace

LifeTexts life_texts(const SynthPlan& plan, std::uint64_t seed) {
  constexpr const char* kLoad = "bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N";
  const Columns columns = columns_of(*plan.lives);
  LifeTexts texts;
  texts.specimens = fmt::format("specimen,lot,{},cycles,status,role", kLoad);
  texts.specimens += columns.days ? ",days" : "";
  texts.specimens += columns.wire_to_bend_ratio ? ",wire_to_bend_ratio" : "";
  texts.specimens += columns.group ? ",group" : "";
  texts.specimens += '\n';
  if (!plan.lives->programs.empty()) {
    texts.blocks = fmt::format("specimen,order,{},cycles\n", kLoad);
  }
  for (const LifeSpecimen& specimen : run_lives(plan, seed)) {
    append_row(*plan.lives, specimen, columns, texts.specimens);
    if (specimen.levels.size() > 1) {
      append_blocks(*plan.lives, specimen, texts.blocks);
    }
  }
  return texts;
}

}  // namespace host_sim::synth
