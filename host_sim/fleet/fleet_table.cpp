#include "host_sim/fleet/fleet_table.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "hal/files/csv.hpp"
#include "hal/files/input_error.hpp"
#include "host_sim/campaign/csv_table.hpp"

namespace host_sim::fleet {

using hal::files::in_quotes;
using hal::files::InputError;
using hal::files::NumberRange;

namespace {

enum FleetColumn : unsigned {
  kTendon,
  kDamagePerHour,
  kDamage,
  kAge,
  kRateLogSd,
  kHoursPerDay,
  kEffectiveTension,
  kModel,
  kCostReplace,
  kCostBreak,
  kFleetColumnCount,
};

constexpr std::array<CsvColumn, kFleetColumnCount> kFleetColumns{{
    {.name = "tendon", .required = true},
    {.name = "damage_per_h", .unit = "per_h"},
    {.name = "damage", .required = true},
    {.name = "age_h", .unit = "h"},
    {.name = "rate_log_sd"},
    {.name = "hours_per_day", .unit = "per_day", .required = true},
    {.name = "effective_tension_N", .unit = "N"},
    {.name = "model"},
    {.name = "cost_replace"},
    {.name = "cost_break"},
}};

constexpr NumberRange kDamageRange{0, 100};
constexpr NumberRange kAgeRange{0, 1e7, true};
constexpr NumberRange kLogSdRange{0, 3};
constexpr NumberRange kHoursRange{0, 24};
constexpr NumberRange kTensionRange{0, 1e6, true};
constexpr NumberRange kCostRange{0, 1e15};

std::optional<double> number_if_given(const CsvTable& table, FleetColumn column,
                                      const NumberRange& range) {
  return table.cell(column).empty() ? std::nullopt : std::optional(table.number(column, range));
}

/// The rate that is given, or the mean one of the age.
double rate_in(const CsvTable& table, double damage, std::optional<double> age_h) {
  const auto given = number_if_given(table, kDamagePerHour, kDamagePerHourRange);
  if (given) {
    return *given;
  }
  if (!age_h) {
    table.place(table.has(kDamagePerHour) ? kDamagePerHour : kAge)
        .fail("a tendon without a rate", "damage_per_h, or age_h in hours of operation");
  }
  const double rate = damage / *age_h;
  if (!kDamagePerHourRange.contains(rate)) {
    table.place(kAge).fail(fmt::format("damage over age_h is {:g} an hour, out of range", rate),
                           hal::files::range_text(kDamagePerHourRange));
  }
  return rate;
}

TendonRow row_in(const CsvTable& table) {
  TendonRow row;
  Tendon& tendon = row.tendon;
  tendon.name = name_in_row(table, kTendon);
  tendon.damage = table.number(kDamage, kDamageRange);
  row.age_h = number_if_given(table, kAge, kAgeRange);
  tendon.damage_per_h = rate_in(table, tendon.damage, row.age_h);
  tendon.rate_log_sd = number_if_given(table, kRateLogSd, kLogSdRange).value_or(0);
  tendon.hours_per_day = table.number(kHoursPerDay, kHoursRange);
  tendon.effective_tension_N = number_if_given(table, kEffectiveTension, kTensionRange);
  tendon.replacement_cost = number_if_given(table, kCostReplace, kCostRange);
  tendon.break_cost = number_if_given(table, kCostBreak, kCostRange);
  row.model = table.text(kModel);
  return row;
}

std::filesystem::path model_path(const std::string& model, const std::filesystem::path& table) {
  return table.parent_path() / model;
}

}  // namespace

std::vector<TendonRow> parse_fleet_table(std::unique_ptr<hal::files::ByteSource> source,
                                         std::string_view name) {
  CsvTable table(std::move(source), name, kFleetColumns);
  if (!table.has(kDamagePerHour) && !table.has(kAge)) {
    table.header_end().fail("no column damage_per_h and none age_h", "one of them");
  }
  std::vector<TendonRow> rows;
  std::unordered_map<std::string, std::uint64_t> lines;
  while (table.next()) {
    TendonRow row = row_in(table);
    const auto [first, is_new] = lines.try_emplace(row.tendon.name, table.line());
    if (!is_new) {
      table.place(kTendon).fail(fmt::format("tendon {} a second time, first in line {}",
                                            in_quotes(row.tendon.name), first->second),
                                "one row for each tendon");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string fleet_table_text(const std::vector<TendonRow>& rows,
                             const std::vector<std::string>& broken) {
  constexpr std::array<std::string_view, 6> kColumns{"tendon", "damage",      "damage_per_h",
                                                     "age_h",  "rate_log_sd", "hours_per_day"};
  std::string text;
  for (const std::string& name : broken) {
    text += fmt::format("# broken: {}\n", hal::files::printable(name));
  }
  text += hal::files::csv_head(kColumns);
  for (const TendonRow& row : rows) {
    hal::files::CsvRow fields;
    fields.add(row.tendon.name);
    fields.add(row.tendon.damage);
    fields.add(row.tendon.damage_per_h);
    fields.add(row.age_h.value_or(std::numeric_limits<double>::quiet_NaN()));
    fields.add(row.tendon.rate_log_sd);
    fields.add(row.tendon.hours_per_day);
    text += fields.line();
  }
  return text;
}

std::vector<std::filesystem::path> models_of(const std::vector<TendonRow>& rows,
                                             const std::filesystem::path& table) {
  std::vector<std::filesystem::path> paths;
  std::set<std::string> seen;
  for (const TendonRow& row : rows) {
    if (!row.model.empty() && seen.insert(row.model).second) {
      paths.push_back(model_path(row.model, table));
    }
  }
  return paths;
}

Fleet fleet_of(const std::vector<TendonRow>& rows, const std::filesystem::path& table,
               const std::string& model) {
  Fleet fleet;
  std::map<std::string, std::size_t> numbers;
  for (const TendonRow& row : rows) {
    if (row.model.empty() && model.empty()) {
      throw InputError(table.string(), 0, 0,
                       fmt::format("tendon {} has no model", in_quotes(row.tendon.name)),
                       "--model for all, or a model in the column model of each row");
    }
    const std::string path = row.model.empty() ? model : model_path(row.model, table).string();
    const auto [number, is_new] = numbers.try_emplace(path, fleet.models.size());
    if (is_new) {
      fleet.models.push_back({path, read_model(path)});
    }
    fleet.tendons.push_back(row.tendon);
    fleet.tendons.back().model = number->second;
  }
  return fleet;
}

}  // namespace host_sim::fleet
