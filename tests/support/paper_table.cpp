#include "tests/support/paper_table.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace host_sim::testing {
namespace {

constexpr std::size_t kColumns = 4;
using Cells = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

Cells cells_of(const std::string& line) {
  Cells cells;
  std::istringstream in(line.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    cells.push_back(trimmed(cell));
  }
  return cells;
}

/// Half a unit of the last digit of a number written as 12.3 or 1.23e4.
double half_last_digit(const std::string& number) {
  const std::size_t exponent_at = number.find('e');
  const std::string mantissa = number.substr(0, exponent_at);
  const std::size_t point_at = mantissa.find('.');
  const auto decimals =
      point_at == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point_at - 1);
  const int exponent =
      exponent_at == std::string::npos ? 0 : std::stoi(number.substr(exponent_at + 1));
  return 0.5 * std::pow(10.0, exponent - decimals);
}

std::optional<std::string> fault_of_numbers(const std::string& cell,
                                            const std::vector<double>& expected, bool as_rounded) {
  std::istringstream in(cell);
  std::size_t i = 0;
  for (std::string number; in >> number; ++i) {
    std::size_t read = 0;
    double value = 0.0;
    try {
      value = std::stod(number, &read);
    } catch (const std::exception&) {
      read = 0;
    }
    if (read != number.size()) {
      return "'" + number + "' is not a number";
    }
    if (i >= expected.size()) {
      continue;
    }
    const double tolerance =
        as_rounded ? half_last_digit(number) * (1 + 1e-9) : 1e-12 * std::abs(expected[i]);
    if (!(std::abs(value - expected[i]) <= tolerance)) {
      return number + " is shown for " + std::to_string(expected[i]);
    }
  }
  if (i != expected.size()) {
    return std::to_string(i) + " numbers are shown for " + std::to_string(expected.size());
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> faults_of_paper_table(const std::string& markdown, const std::string& mark,
                                               std::span<const PaperRow> rows) {
  const std::size_t begin = markdown.find("<!-- " + mark + ":begin -->");
  const std::size_t end = markdown.find("<!-- " + mark + ":end -->");
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    return {"there is no table between the markers of " + mark};
  }

  std::vector<std::string> faults;
  std::map<std::string, Cells> table;
  std::istringstream in(markdown.substr(begin, end - begin));
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("|") || line.starts_with("|-") || line.starts_with("| quantity ")) {
      continue;
    }
    const Cells cells = cells_of(line);
    if (cells.size() != kColumns) {
      faults.push_back("not four columns: " + line);
    } else if (!table.emplace(cells[0], cells).second) {
      faults.push_back(cells[0] + ": twice in the table");
    }
  }

  for (const PaperRow& row : rows) {
    const auto found = table.extract(row.quantity);
    if (!found) {
      faults.push_back(row.quantity + ": not in the table");
      continue;
    }
    const Cells& cells = found.mapped();
    if (const auto fault = fault_of_numbers(cells[1], row.paper, false)) {
      faults.push_back(row.quantity + ", paper: " + *fault);
    }
    if (const auto fault = fault_of_numbers(cells[2], row.ours, true)) {
      faults.push_back(row.quantity + ", ours: " + *fault);
    }
    if (cells[3].empty()) {
      faults.push_back(row.quantity + ": no reason given");
    }
  }
  for (const auto& [quantity, cells] : table) {
    faults.push_back(quantity + ": not a quantity that is computed");
  }
  return faults;
}

}  // namespace host_sim::testing
