#include "host_sim/campaign/columns.hpp"

namespace host_sim {

std::string name_in_row(const CsvTable& table, std::size_t column) {
  const std::string& name = table.text(column);
  if (name.empty()) {
    table.place(column).fail("specimen is empty", "the name of a specimen");
  }
  return name;
}

double cycles_in_row(const CsvTable& table, std::size_t column) {
  return table.number(column, {0.0, 1e18, true});
}

}  // namespace host_sim
