#include "host_sim/calibrate/output/text_table.hpp"

#include <algorithm>

#include "host_sim/io/printable.hpp"

namespace host_sim::calibrate {

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> widths(rows_.front().size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], character_count(row[i]));
    }
  }
  return widths;
}

void TextTable::write(std::ostream& out) const {
  const std::vector<std::size_t> width = widths();
  for (const auto& row : rows_) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(width[i] - character_count(row[i]), ' ');
      line += i == 0 ? row[i] + padding : "  " + padding + row[i];
    }
    line.resize(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

}  // namespace host_sim::calibrate
