#include "host_sim/campaign/columns.hpp"

#include <fmt/format.h>

namespace host_sim {

std::string name_in_row(const CsvTable& table, std::size_t column) {
  const std::string& name = table.text(column);
  if (name.empty()) {
    const std::string_view kind = table.name(column);
    table.place(column).fail(fmt::format("{} is empty", kind),
                             fmt::format("the name of a {}", kind));
  }
  return name;
}

double cycles_in_row(const CsvTable& table, std::size_t column) {
  return table.number(column, {0.0, 1e18, true});
}

}  // namespace host_sim
