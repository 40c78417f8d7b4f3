#include "host_sim/synth/campaign/lives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/life_departures.hpp"

namespace host_sim::synth {
namespace {

std::unique_ptr<LifePart> make(const Departure& departure) {
  const auto kinds = departure.outside ? outside_life_kinds() : life_kinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const LifeKind& candidate) {
    return candidate.id == departure.id;
  });
  return kind->make(departure.values);
}

std::vector<std::unique_ptr<LifePart>> parts_for(const SynthPlan& plan, const SpecimenPlace& place,
                                                 std::uint64_t seed) {
  std::vector<std::unique_ptr<LifePart>> parts;
  for (const Departure& departure : plan.departures) {
    if (departure.of_life) {
      parts.push_back(make(departure));
      parts.back()->begin(place, seed);
    }
  }
  return parts;
}

/// Where specimens come from and run. Rigs take turns within a lot, so that neither hides the
/// other.
SpecimenPlace place_of(const LifePlan& plan, std::size_t number, std::size_t in_level,
                       std::size_t level) {
  SpecimenPlace place;
  place.number = number;
  place.lot = (plan.lots_by == LifePlan::LotsBy::level ? level : in_level) % plan.lots;
  place.rig = (in_level / plan.lots) % plan.rigs;
  return place;
}

std::vector<LifeStep> steps_of(const LifePlan& plan, const std::vector<std::size_t>& levels,
                               const std::vector<double>& cycles) {
  std::vector<LifeStep> steps;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LifeLevel& level = plan.levels[levels[i]];
    steps.push_back({level.load, i < cycles.size() ? cycles[i] : level.suspend_at_cycles});
  }
  return steps;
}

class Runner {
 public:
  Runner(const SynthPlan& plan, std::uint64_t seed)
      : plan_(plan),
        seed_(seed),
        model_{*plan.model.cable, plan.model.sheath->friction_coefficient, *plan.model.life} {}

  /// Specimens that all go through the same levels; `group` stands for the level in dealing lots.
  void run(const std::vector<std::size_t>& levels, const std::vector<double>& cycles,
           std::size_t count, bool validation, std::size_t group) {
    const std::vector<LifeStep> steps = steps_of(*plan_.lives, levels, cycles);
    for (std::size_t i = 0; i < count; ++i) {
      LifeSpecimen specimen;
      const std::size_t number = specimens_.size();
      specimen.place = place_of(*plan_.lives, number, i, group);
      specimen.levels = levels;
      specimen.validation = validation;
      specimen.storage_days = plan_.lives->storage_days[number % plan_.lives->storage_days.size()];
      Random random(seed_, kStrengthStream, number);
      const double strength = std::pow(exponential(random), 1 / plan_.model.life->weibull_shape);
      specimen.result = run_specimen(model_, steps, strength, specimen.storage_days,
                                     parts_for(plan_, specimen.place, seed_));
      specimens_.push_back(std::move(specimen));
    }
  }

  std::vector<LifeSpecimen> take() { return std::move(specimens_); }

 private:
  const SynthPlan& plan_;
  std::uint64_t seed_;
  LifeModel model_;
  std::vector<LifeSpecimen> specimens_;
};

}  // namespace

std::string specimen_name(std::size_t number) {
  return fmt::format("w{:04}", number + 1);
}

std::vector<LifeSpecimen> run_lives(const SynthPlan& plan, std::uint64_t seed) {
  const LifePlan& lives = *plan.lives;
  Runner runner(plan, seed);
  for (std::size_t i = 0; i < lives.levels.size(); ++i) {
    runner.run({i}, {}, lives.levels[i].specimens, lives.levels[i].validation, i);
  }
  for (std::size_t i = 0; i < lives.programs.size(); ++i) {
    const LifeProgram& program = lives.programs[i];
    runner.run(program.levels, program.cycles, program.specimens, program.validation,
               lives.levels.size() + i);
  }
  return runner.take();
}

namespace {

/// The columns of specimens.csv that not every campaign has.
struct Columns {
  bool days = false;
  bool wire_to_bend_ratio = false;
  bool group = false;
  bool cycles_from = false;
};

/// What the table says of a life.
struct Seen {
  std::string cycles, cycles_from;
  std::string_view status;
};

std::string whole(double cycles) {
  return fmt::format("{:.0f}", cycles);
}

Seen seen_of(const LifePlan& plan, const LifeSpecimen& specimen) {
  const auto& of_steps = specimen.result.cycles;
  const double cycles = std::accumulate(of_steps.begin(), of_steps.end(), 0.0);
  const LifeLevel& level = plan.levels[specimen.levels.front()];
  if (!specimen.result.failed) {
    return {whole(cycles), "", "suspended"};
  }
  if (specimen.levels.size() > 1 || level.inspect_every_cycles == 0) {
    return {whole(cycles), "", "failed"};
  }
  const double step = level.inspect_every_cycles;
  const double from = (std::ceil(cycles / step) - 1) * step;
  const double found = std::min(from + step, level.suspend_at_cycles);
  return from > 0 ? Seen{whole(found), whole(from), "interval"} : Seen{whole(found), "", "left"};
}

/// Of each specimen. Those under a level alone stand together, in the order of the levels.
std::vector<Seen> seen_of(const LifePlan& plan, const std::vector<LifeSpecimen>& specimens) {
  std::vector<Seen> seen;
  seen.reserve(specimens.size());
  for (const LifeSpecimen& specimen : specimens) {
    seen.push_back(seen_of(plan, specimen));
  }
  std::size_t first = 0;
  for (const LifeLevel& level : plan.levels) {
    std::vector<std::size_t> places(level.specimens);
    std::iota(places.begin(), places.end(), first);
    std::ranges::stable_sort(places, {},
                             [&](std::size_t i) { return specimens[i].result.cycles.front(); });
    for (std::size_t i = 0; i < level.trim_low; ++i) {
      seen[places[i]] = {"", "", "trimmed_low"};
    }
    for (std::size_t i = places.size() - level.trim_high; i < places.size(); ++i) {
      seen[places[i]] = {"", "", "trimmed_high"};
    }
    first += level.specimens;
  }
  return seen;
}

Columns columns_of(const LifePlan& plan) {
  const bool has_ratio =
      std::any_of(plan.levels.begin(), plan.levels.end(),
                  [](const LifeLevel& level) { return level.load.wire_to_bend_ratio > 0; });
  const bool inspected = std::ranges::any_of(
      plan.levels, [](const LifeLevel& level) { return level.inspect_every_cycles > 0; });
  return {plan.record_days, has_ratio, plan.rigs > 1, inspected};
}

std::string load_text(const LifeLoad& load) {
  return fmt::format("{},{},{}", load.bend_angle_deg, load.output_mean_N, load.output_amplitude_N);
}

void append_row(const LifePlan& plan, const LifeSpecimen& specimen, const Seen& seen,
                const Columns& columns, std::string& text) {
  const LifeLoad& load = plan.levels[specimen.levels.front()].load;
  const bool constant = specimen.levels.size() == 1;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{},lot{},{},{},{},{}", specimen_name(specimen.place.number),
                 specimen.place.lot + 1, constant ? load_text(load) : ",,", seen.cycles,
                 seen.status, specimen.validation ? "validation" : "fit");
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
  if (columns.cycles_from) {
    text += ',';
    text += seen.cycles_from;
  }
  text += '\n';
}

void append_blocks(const LifePlan& plan, const LifeSpecimen& specimen, std::string& text) {
  const auto& cycles = specimen.result.cycles;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{:.0f}\n",
                   specimen_name(specimen.place.number), i + 1,
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
  texts.specimens += columns.cycles_from ? ",cycles_from" : "";
  texts.specimens += '\n';
  if (!plan.lives->programs.empty()) {
    texts.blocks = fmt::format("specimen,order,{},cycles\n", kLoad);
  }
  const std::vector<LifeSpecimen> specimens = run_lives(plan, seed);
  const std::vector<Seen> seen = seen_of(*plan.lives, specimens);
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    const LifeSpecimen& specimen = specimens[i];
    append_row(*plan.lives, specimen, seen[i], columns, texts.specimens);
    if (specimen.levels.size() > 1) {
      append_blocks(*plan.lives, specimen, texts.blocks);
    }
  }
  return texts;
}

}  // namespace host_sim::synth
