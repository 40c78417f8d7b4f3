#include "host_sim/campaign/specimens_file.hpp"

#include <fmt/format.h>

#include <array>
#include <unordered_map>
#include <utility>

#include "host_sim/campaign/columns.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/campaign/load_table.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim {
namespace {

enum Column : unsigned {
  kSpecimen = kLoadColumnCount,
  kLot,
  kCycles,
  kStatus,
  kDays,
  kWireToBendRatio,
  kGroup,
  kRole,
  kColumnCount,
};

std::array<CsvColumn, kColumnCount> columns() {
  std::array<CsvColumn, kColumnCount> columns{};
  std::size_t next = 0;
  for (const CsvColumn& column : load_columns()) {
    columns[next++] = column;
  }
  columns[kSpecimen] = {.name = "specimen", .required = true};
  columns[kLot] = {.name = "lot", .required = true};
  columns[kCycles] = {.name = "cycles", .required = true};
  columns[kStatus] = {.name = "status", .required = true};
  columns[kDays] = {.name = "days"};
  columns[kWireToBendRatio] = {.name = "wire_to_bend_ratio"};
  columns[kGroup] = {.name = "group"};
  columns[kRole] = {.name = "role"};
  return columns;
}

Campaign::Status status_in(const CsvTable& table) {
  const std::string& text = table.cell(kStatus);
  if (text == "failed") {
    return Campaign::Status::failed;
  }
  if (text == "suspended") {
    return Campaign::Status::suspended;
  }
  table.place(kStatus).fail(fmt::format("status is {}", in_quotes(text)), "failed, suspended");
}

Campaign::Role role_in(const CsvTable& table) {
  const std::string& text = table.cell(kRole);
  if (text.empty() || text == "fit") {
    return Campaign::Role::fit;
  }
  if (text == "validation") {
    return Campaign::Role::validation;
  }
  table.place(kRole).fail(fmt::format("role is {}", in_quotes(text)), "fit, validation");
}

SpecimenRow row_in(const CsvTable& table) {
  SpecimenRow row;
  Campaign::Specimen& specimen = row.specimen;
  specimen.name = name_in_row(table, kSpecimen);
  specimen.lot = table.text(kLot);
  specimen.group = table.text(kGroup);
  specimen.status = status_in(table);
  specimen.role = role_in(table);
  if (!table.cell(kDays).empty()) {
    specimen.days = table.number(kDays, {0.0, 1e6});
  }
  if (!table.cell(kWireToBendRatio).empty()) {
    specimen.wire_to_bend_ratio = table.number(kWireToBendRatio, {0.0, 1e6, true});
  }
  specimen.line = table.line();
  row.cycles = cycles_in_row(table, kCycles);
  row.load = load_in_row(table);
  row.load.check();
  row.name_place = table.place(kSpecimen);
  row.cycles_place = table.place(kCycles);
  return row;
}

}  // namespace

std::vector<SpecimenRow> parse_specimens(std::unique_ptr<ByteSource> source,
                                         std::string_view name) {
  CsvTable table(std::move(source), name, columns());
  check_load_columns(table);
  std::vector<SpecimenRow> rows;
  std::unordered_map<std::string, std::uint64_t> lines;
  while (table.next()) {
    SpecimenRow row = row_in(table);
    const auto [first, is_new] = lines.try_emplace(row.specimen.name, row.specimen.line);
    if (!is_new) {
      row.name_place.fail(fmt::format("specimen {} a second time, first in line {}",
                                      in_quotes(row.specimen.name), first->second),
                          "one row for each specimen");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace host_sim
