#include "host_sim/io/csv_row.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/io/printable.hpp"

namespace host_sim {
namespace {

std::string field(std::string_view text) {
  std::string safe = printable(text);
  if (safe.find_first_of(",\"") == std::string::npos) {
    return safe;
  }
  for (std::size_t at = safe.find('"'); at != std::string::npos; at = safe.find('"', at + 2)) {
    safe.insert(at, 1, '"');
  }
  return '"' + safe + '"';
}

}  // namespace

void CsvRow::add(std::string_view text) {
  fields_.push_back(field(text));
}

void CsvRow::add(double value) {
  fields_.push_back(std::isnan(value) ? "" : fmt::format("{}", value));
}

std::string CsvRow::line() const {
  return fmt::format("{}\n", fmt::join(fields_, ","));
}

std::string csv_head(std::span<const std::string_view> columns) {
  CsvRow row;
  for (const std::string_view column : columns) {
    row.add(column);
  }
  return row.line();
}

}  // namespace host_sim
