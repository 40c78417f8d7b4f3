#include "host_sim/replay/table_row.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "host_sim/io/csv_row.hpp"

namespace host_sim {
namespace {

constexpr std::array<std::string_view, 29> kColumns{"profile",
                                                    "model",
                                                    "input",
                                                    "samples",
                                                    "duration_s",
                                                    "cycles_closed",
                                                    "cycles_open_half",
                                                    "damage_closed",
                                                    "damage_open",
                                                    "damage_total",
                                                    "reference_damage_closed",
                                                    "reference_damage_open",
                                                    "reference_damage_total",
                                                    "relative_error",
                                                    "equivalent_effective_tension_N",
                                                    "peak_tension_N",
                                                    "survival_probability",
                                                    "repeats_to_B10",
                                                    "repeats_to_B50",
                                                    "repeats_to_mean",
                                                    "repeats_to_B90",
                                                    "overloads",
                                                    "missing_samples",
                                                    "flags",
                                                    "extensions",
                                                    "not_evaluated",
                                                    "warnings",
                                                    "model_digest",
                                                    "error"};

void add(CsvRow& row, const DamageSplit& damage) {
  row.add(damage.closed);
  row.add(damage.open);
  row.add(damage.total);
}

void add(CsvRow& row, const reference::LifePoints& repeats) {
  row.add(repeats.b10);
  row.add(repeats.b50);
  row.add(repeats.mean);
  row.add(repeats.b90);
}

std::vector<std::string_view> ids_of(const std::vector<NotEvaluated>& effects) {
  std::vector<std::string_view> ids;
  ids.reserve(effects.size());
  for (const NotEvaluated& effect : effects) {
    ids.emplace_back(effect.id);
  }
  return ids;
}

}  // namespace

std::string replay_table_head() {
  return csv_head(kColumns);
}

std::string replay_table_row(std::string_view profile, std::string_view model,
                             const ReplayResult& result) {
  CsvRow row;
  row.add(profile);
  row.add(model);
  row.add(to_string(result.input));
  row.add(result.samples);
  row.add(result.duration_s);
  row.add(result.cycles.closed);
  row.add(result.cycles.open_half);
  add(row, result.damage);
  add(row, result.reference_damage);
  row.add(result.relative_error);
  row.add(result.equivalent_effective_tension_N);
  row.add(result.peak_tension_N);
  row.add(result.survival_probability);
  add(row, result.repeats_to);
  row.add(result.overloads);
  row.add(result.missing_samples);
  row.add(fmt::format("{}", fmt::join(result.flags, " ")));
  row.add(fmt::format("{}", fmt::join(result.extensions, " ")));
  row.add(fmt::format("{}", fmt::join(ids_of(result.not_evaluated), " ")));
  row.add(fmt::format("{}", fmt::join(result.warnings, "; ")));
  row.add(result.model_digest);
  row.fill_to(kColumns.size());
  return row.line();
}

std::string refused_replay_row(std::string_view profile, std::string_view model,
                               std::string_view error) {
  CsvRow row;
  row.add(profile);
  row.add(model);
  row.fill_to(kColumns.size() - 1);
  row.add(error);
  return row.line();
}

}  // namespace host_sim
