#include "host_sim/campaign/blocks_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "host_sim/campaign/columns.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/campaign/load_table.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim {
namespace {

enum Column : unsigned { kSpecimen = kLoadColumnCount, kOrder, kCycles, kColumnCount };

std::array<CsvColumn, kColumnCount> columns() {
  std::array<CsvColumn, kColumnCount> columns{};
  std::size_t next = 0;
  for (const CsvColumn& column : load_columns()) {
    columns[next++] = column;
  }
  columns[kSpecimen] = {.name = "specimen", .required = true};
  columns[kOrder] = {.name = "order", .required = true};
  columns[kCycles] = {.name = "cycles", .required = true};
  return columns;
}

std::uint64_t order_in(const CsvTable& table) {
  const double order = table.number(kOrder, {1.0, 1e6});
  if (order != std::floor(order)) {
    table.place(kOrder).fail(fmt::format("order is {}", in_quotes(table.cell(kOrder))),
                             "a whole number from 1");
  }
  return static_cast<std::uint64_t>(order);
}

BlockRow row_in(const CsvTable& table) {
  BlockRow row;
  row.specimen = name_in_row(table, kSpecimen);
  row.order = order_in(table);
  row.cycles = cycles_in_row(table, kCycles);
  row.load = load_in_row(table);
  row.specimen_place = table.place(kSpecimen);
  row.order_place = table.place(kOrder);
  if (row.load.kind() == LoadKind::none) {
    row.specimen_place.fail("a block without a load", row.load.accepted);
  }
  return row;
}

}  // namespace

std::vector<BlockRow> parse_blocks(std::unique_ptr<ByteSource> source, std::string_view name) {
  CsvTable table(std::move(source), name, columns());
  check_load_columns(table);
  std::vector<BlockRow> rows;
  while (table.next()) {
    rows.push_back(row_in(table));
  }
  return rows;
}

}  // namespace host_sim
