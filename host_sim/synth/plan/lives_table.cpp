#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "host_sim/reference/equations.hpp"
#include "host_sim/synth/plan/tables.hpp"

namespace host_sim::synth {

using hal::files::NumberKey;
using hal::files::TomlTable;

namespace {

constexpr NumberKey kLevelBendAngle{"bend_angle_deg", "deg", {0, 1800}};
constexpr NumberKey kMean{"output_tension_mean_N", "N", {0, 1e6}};
constexpr NumberKey kAmplitude{"output_tension_amplitude_N", "N", {0, 1e6, true}};
constexpr NumberKey kFrequency{"frequency_Hz", "Hz", {0.001, 1000}};
constexpr NumberKey kRatio{"wire_to_bend_ratio", "", {0, 1, true}};
constexpr NumberKey kSpecimens{"specimens", "", {1, 10'000}};
constexpr NumberKey kSuspend{"suspend_at_cycles", "cycles", {1, 1e15}};
constexpr NumberKey kInspect{"inspect_every_cycles", "cycles", {1, 1e15}};
constexpr NumberKey kTrimLow{"trim_low", "", {0, 10'000}};
constexpr NumberKey kTrimHigh{"trim_high", "", {0, 10'000}};
constexpr std::array kLevel{kLevelBendAngle, kMean,    kAmplitude, kFrequency, kRatio,
                            kSpecimens,      kSuspend, kInspect,   kTrimLow,   kTrimHigh};
constexpr NumberKey kLevelSpecimens{"specimens", "", {0, 10'000}};

constexpr NumberKey kLevels{"levels", "", {1, 10'000}};
constexpr NumberKey kCycles{"cycles", "", {1, 1e15}};
constexpr std::array kProgram{kLevels, kCycles, kSpecimens};

constexpr NumberKey kLots{"lots", "", {1, 10'000}};
constexpr NumberKey kRigs{"rigs", "", {1, 1000}};
constexpr NumberKey kStorage{"storage_days", "days", {0, 1e5}};
constexpr std::array kLives{kLots, kRigs, kStorage};
constexpr std::array<std::string_view, 4> kLivesOthers{"lots_by", "record_days", "level",
                                                       "program"};
constexpr std::array<std::string_view, 2> kLotsBy{"specimen", "level"};
constexpr std::array<std::string_view, 1> kRole{"role"};
constexpr std::array<std::string_view, 2> kRoles{"fit", "validation"};

/// Only where all lives of a level are known is it clear which are dropped.
void check_trimming(const TomlTable& table, const LifeLevel& level) {
  const std::size_t dropped = level.trim_low + level.trim_high;
  const std::string_view key = level.trim_low > 0 ? kTrimLow.name : kTrimHigh.name;
  if (dropped == 0) {
    return;
  }
  for (const NumberKey& other : {kSuspend, kInspect}) {
    if (table.has(other.name)) {
      table.fail(table.place_of(key), fmt::format("{} beside {}", key, other.name),
                 "lives that are dropped from levels whose lives are all known");
    }
  }
  if (dropped >= level.specimens) {
    table.fail(table.place_of(key),
               fmt::format("{} of {} specimens are dropped", dropped, level.specimens),
               "fewer than there are");
  }
}

LifeLevel level_in(const TomlTable& table) {
  table.refuse_unknown_keys(kLevel, kRole);
  LifeLevel level;
  level.load.bend_angle_deg = table.number(kLevelBendAngle);
  level.load.output_mean_N = table.number(kMean);
  level.load.output_amplitude_N = table.number(kAmplitude);
  level.load.frequency_Hz = number_or(table, kFrequency, 1);
  level.load.wire_to_bend_ratio = number_or(table, kRatio, 0);
  level.specimens = whole_or(table, kLevelSpecimens, 0);
  if (table.has(kSuspend.name)) {
    level.suspend_at_cycles = static_cast<double>(whole_or(table, kSuspend, 0));
  }
  if (table.has(kInspect.name)) {
    level.inspect_every_cycles = static_cast<double>(whole_or(table, kInspect, 0));
  }
  level.trim_low = whole_or(table, kTrimLow, 0);
  level.trim_high = whole_or(table, kTrimHigh, 0);
  check_trimming(table, level);
  level.validation = choice_of(table, "role", kRoles) == 1;
  return level;
}

LifeProgram program_in(const TomlTable& table, std::size_t levels) {
  table.refuse_unknown_keys(kProgram, kRole);
  LifeProgram program;
  for (const double place : numbers(table, kLevels)) {
    if (place != static_cast<double>(static_cast<std::size_t>(place)) ||
        place > static_cast<double>(levels)) {
      table.fail(table.place_of("levels"), fmt::format("levels holds {}", place),
                 fmt::format("numbers of [[lives.level]], 1..{}", levels));
    }
    program.levels.push_back(static_cast<std::size_t>(place) - 1);
  }
  program.cycles = numbers(table, kCycles);
  for (const double cycles : program.cycles) {
    if (cycles != std::floor(cycles)) {
      table.fail(table.place_of("cycles"), fmt::format("cycles holds {}", cycles),
                 fmt::format("whole numbers, {}", range_text(kCycles.range)));
    }
  }
  if (program.levels.size() < 2 || program.cycles.size() + 1 != program.levels.size()) {
    table.fail(table.place_of("cycles"),
               fmt::format("{} levels with {} numbers of cycles", program.levels.size(),
                           program.cycles.size()),
               "at least two levels, and cycles for all but the last");
  }
  static_cast<void>(table.number(kSpecimens));
  program.specimens = whole_or(table, kSpecimens, 0);
  program.validation = choice_of(table, "role", kRoles) == 1;
  return program;
}

}  // namespace

LifePlan lives_in(const TomlTable& table) {
  table.refuse_unknown_keys(kLives, kLivesOthers);
  LifePlan plan;
  plan.lots = whole_or(table, kLots, 1);
  plan.lots_by = static_cast<LifePlan::LotsBy>(choice_of(table, "lots_by", kLotsBy));
  plan.rigs = whole_or(table, kRigs, 1);
  plan.storage_days = numbers_or(table, kStorage, 0);
  plan.record_days = table.flag("record_days");
  for (const TomlTable& level : tables(table, "level")) {
    plan.levels.push_back(level_in(level));
  }
  for (const TomlTable& program : tables(table, "program")) {
    plan.programs.push_back(program_in(program, plan.levels.size()));
  }
  if (plan.specimens() == 0) {
    table.fail(table.place(), "no specimens", "[[lives.level]] or [[lives.program]] with some");
  }
  return plan;
}

std::size_t LifePlan::specimens() const {
  std::size_t sum = 0;
  for (const LifeLevel& level : levels) {
    sum += level.specimens;
  }
  for (const LifeProgram& program : programs) {
    sum += program.specimens;
  }
  return sum;
}

namespace {

constexpr double kLeast_N = 0.01;

}  // namespace

void check_lives(const TomlTable& top, const SynthPlan& plan) {
  const TomlTable table = top.table("lives");
  if (!plan.model.cable || !plan.model.sheath || !plan.model.life) {
    fail_for_model(top,
                   !plan.model.cable    ? "cable"
                   : !plan.model.sheath ? "sheath"
                                        : "life",
                   "[lives]");
  }
  for (const LifeLevel& level : plan.lives->levels) {
    const LifeLoad& load = level.load;
    const double efficiency = reference::capstan_efficiency(
        plan.model.sheath->friction_coefficient, load.bend_angle_deg * std::numbers::pi / 180);
    const double input_maximum_N = (load.output_mean_N + load.output_amplitude_N) / efficiency;
    if (load.output_amplitude_N > load.output_mean_N || load.output_amplitude_N < kLeast_N ||
        !(input_maximum_N < plan.model.cable->ultimate_tension_N)) {
      table.fail(table.place_of("level"),
                 fmt::format("a level of {} +- {} N at {} deg", level.load.output_mean_N,
                             level.load.output_amplitude_N, level.load.bend_angle_deg),
                 "an amplitude up to the mean, and an input tension below the ultimate one");
    }
  }
}

}  // namespace host_sim::synth
