#include "host_sim/campaign/load_table.hpp"

namespace host_sim {

std::array<CsvColumn, kLoadColumnCount> load_columns() {
  std::array<CsvColumn, kLoadColumnCount> columns{};
  for (std::size_t id = 0; id < kLoadColumnCount; ++id) {
    columns[id] = {.name = load_keys()[id].name, .unit = load_keys()[id].unit};
  }
  return columns;
}

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

}  // namespace host_sim
