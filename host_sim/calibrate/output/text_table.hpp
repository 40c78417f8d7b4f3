#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace host_sim::calibrate {

/// Rows of cells in aligned columns for a terminal: the first column to the left, the others to the
/// right.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> head) : rows_{std::move(head)} {}

  /// @pre as many cells as the head has
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  void write(std::ostream& out) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;

  std::vector<std::vector<std::string>> rows_;
};

}  // namespace host_sim::calibrate
