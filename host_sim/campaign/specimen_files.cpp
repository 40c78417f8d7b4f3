#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "hal/files/text.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/campaign/csv_table.hpp"

namespace host_sim {

using hal::files::ByteSource;
using hal::files::in_quotes;

namespace {

/// The columns of a load, for a table whose first columns are these.
std::array<CsvColumn, kLoadColumnCount> load_columns() {
  std::array<CsvColumn, kLoadColumnCount> columns{};
  for (std::size_t id = 0; id < kLoadColumnCount; ++id) {
    columns[id] = {.name = load_keys()[id].name, .unit = load_keys()[id].unit};
  }
  return columns;
}

/// Throws InputError where the file has some columns of a kind of load but not all.
void check_load_columns(const CsvTable& table) {
  GivenLoad columns;
  for (std::size_t id = 0; id < kLoadColumnCount; ++id) {
    columns.numbers[id].given = table.has(id);
    columns.numbers[id].place = table.header_end();
  }
  for (const LoadKind kind : {LoadKind::output_tension, LoadKind::input_tension}) {
    columns.only(kind).check();
  }
}

/// The load of this row: empty cells give nothing.
/// @throws InputError for what is not a number in its range
GivenLoad load_in_row(const CsvTable& table) {
  GivenLoad load;
  for (std::size_t id = 0; id < kLoadColumnCount; ++id) {
    GivenLoad::Number& number = load.numbers[id];
    number.place = table.place(id);
    number.given = !table.cell(id).empty();
    if (number.given) {
      number.value = table.number(id, load_keys()[id].range);
    }
  }
  return load;
}

enum SpecimenColumn : unsigned {
  kSpecimen = kLoadColumnCount,
  kLot,
  kCycles,
  kStatus,
  kDays,
  kWireToBendRatio,
  kGroup,
  kRole,
  kCyclesFrom,
  kSpecimenColumnCount,
};

std::array<CsvColumn, kSpecimenColumnCount> specimen_columns() {
  std::array<CsvColumn, kSpecimenColumnCount> columns{};
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
  columns[kCyclesFrom] = {.name = "cycles_from"};
  return columns;
}

constexpr std::array kStatuses{
    std::pair{std::string_view("failed"), Campaign::Status::failed},
    std::pair{std::string_view("suspended"), Campaign::Status::suspended},
    std::pair{std::string_view("interval"), Campaign::Status::interval},
    std::pair{std::string_view("left"), Campaign::Status::left},
    std::pair{std::string_view("trimmed_low"), Campaign::Status::trimmed_low},
    std::pair{std::string_view("trimmed_high"), Campaign::Status::trimmed_high},
};

Campaign::Status status_in(const CsvTable& table) {
  const std::string& text = table.cell(kStatus);
  std::vector<std::string_view> accepted;
  for (const auto& [name, status] : kStatuses) {
    if (text == name) {
      return status;
    }
    accepted.push_back(name);
  }
  table.place(kStatus).fail(fmt::format("status is {}", in_quotes(text)),
                            fmt::format("{}", fmt::join(accepted, ", ")));
}

/// The cycles of a row; 0 where the life was dropped, which has none.
double cycles_in(const CsvTable& table, bool trimmed) {
  if (!trimmed) {
    return cycles_in_row(table, kCycles);
  }
  if (!table.cell(kCycles).empty()) {
    table.place(kCycles).fail(
        fmt::format("cycles {} of a specimen that was trimmed", in_quotes(table.cell(kCycles))),
        "an empty cell, or status failed where the life counts");
  }
  return 0;
}

/// Cycles at the last inspection before the one that found the specimen broken; 0 where no status
/// asks for them.
double cycles_from_in(const CsvTable& table, Campaign::Status status, double cycles) {
  constexpr std::string_view kAccepted =
      "cycles_from above 0 and below cycles: at the last inspection before it was found broken";
  const bool given = table.has(kCyclesFrom) && !table.cell(kCyclesFrom).empty();
  if (status != Campaign::Status::interval) {
    if (given) {
      table.place(kCyclesFrom)
          .fail(fmt::format("cycles_from {} of a specimen with status {}",
                            in_quotes(table.cell(kCyclesFrom)), in_quotes(table.cell(kStatus))),
                "an empty cell, or status interval");
    }
    return 0;
  }
  if (!given) {
    table.place(table.has(kCyclesFrom) ? kCyclesFrom : kStatus)
        .fail("status interval without cycles_from", kAccepted);
  }
  const double from = cycles_in_row(table, kCyclesFrom);
  if (from >= cycles) {
    table.place(kCyclesFrom)
        .fail(fmt::format("cycles_from is {}, and cycles {}", from, cycles), kAccepted);
  }
  return from;
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

SpecimenRow specimen_in(const CsvTable& table) {
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
  row.cycles = cycles_in(table, specimen.trimmed());
  specimen.from_cycles = cycles_from_in(table, specimen.status, row.cycles);
  row.load = load_in_row(table);
  row.load.check();
  row.name_place = table.place(kSpecimen);
  row.cycles_place = table.place(kCycles);
  row.status_place = table.place(kStatus);
  return row;
}

}  // namespace

std::vector<SpecimenRow> parse_specimens(std::unique_ptr<ByteSource> source,
                                         std::string_view name) {
  CsvTable table(std::move(source), name, specimen_columns());
  check_load_columns(table);
  std::vector<SpecimenRow> rows;
  std::unordered_map<std::string, std::uint64_t> lines;
  while (table.next()) {
    SpecimenRow row = specimen_in(table);
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

namespace {

enum BlockColumn : unsigned {
  kBlockSpecimen = kLoadColumnCount,
  kBlockOrder,
  kBlockCycles,
  kBlockColumnCount
};

std::array<CsvColumn, kBlockColumnCount> block_columns() {
  std::array<CsvColumn, kBlockColumnCount> columns{};
  std::size_t next = 0;
  for (const CsvColumn& column : load_columns()) {
    columns[next++] = column;
  }
  columns[kBlockSpecimen] = {.name = "specimen", .required = true};
  columns[kBlockOrder] = {.name = "order", .required = true};
  columns[kBlockCycles] = {.name = "cycles", .required = true};
  return columns;
}

std::uint64_t order_in(const CsvTable& table) {
  const double order = table.number(kBlockOrder, {1.0, 1e6});
  if (order != std::floor(order)) {
    table.place(kBlockOrder)
        .fail(fmt::format("order is {}", in_quotes(table.cell(kBlockOrder))),
              "a whole number from 1");
  }
  return static_cast<std::uint64_t>(order);
}

BlockRow block_in(const CsvTable& table) {
  BlockRow row;
  row.specimen = name_in_row(table, kBlockSpecimen);
  row.order = order_in(table);
  row.cycles = cycles_in_row(table, kBlockCycles);
  row.load = load_in_row(table);
  row.specimen_place = table.place(kBlockSpecimen);
  row.order_place = table.place(kBlockOrder);
  if (row.load.kind() == LoadKind::none) {
    row.specimen_place.fail("a block without a load", row.load.accepted);
  }
  return row;
}

}  // namespace

std::vector<BlockRow> parse_blocks(std::unique_ptr<ByteSource> source, std::string_view name) {
  CsvTable table(std::move(source), name, block_columns());
  check_load_columns(table);
  std::vector<BlockRow> rows;
  while (table.next()) {
    rows.push_back(block_in(table));
  }
  return rows;
}

}  // namespace host_sim
