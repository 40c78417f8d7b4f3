#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/csv.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/text.hpp"

namespace host_sim {

/// A place in a file, counted from 1 in characters.
struct FilePosition {
  std::string file;
  std::uint64_t line = 0;
  std::uint64_t column = 0;

  /// @throws InputError
  [[noreturn]] void fail(std::string_view found, std::string_view accepted) const {
    throw hal::files::InputError(file, line, column, found, accepted);
  }
};

/// A column that a table may hold.
struct CsvColumn {
  std::string_view name;
  std::string_view unit = {};  ///< the suffix of `name`, empty if it has none
  bool required = false;
};

/// Reads a table (CSV in any dialect, one header line, `#` starts a comment line) row by row, the
/// columns in any order. All functions throw InputError.
class CsvTable {
 public:
  /// Reads the header; `name` stands for the file in errors.
  CsvTable(std::unique_ptr<hal::files::ByteSource> source, std::string_view name,
           std::span<const CsvColumn> columns);

  std::string_view name(std::size_t column) const { return columns_[column].name; }

  bool has(std::size_t column) const { return fields_[column] != kAbsent; }

  /// Goes to the next row; false at the end. A table without rows is refused.
  bool next();

  /// The number of this row's line.
  std::uint64_t line() const noexcept { return line_; }

  /// A cell of this row, empty where the file lacks the column.
  const std::string& cell(std::size_t column) const;

  /// A cell as a text without hidden characters.
  const std::string& text(std::size_t column) const;

  /// A cell as a finite number in its range.
  double number(std::size_t column, const hal::files::NumberRange& range) const;

  /// The end of the header, where a column that is missing would stand.
  const FilePosition& header_end() const noexcept { return header_end_; }

  /// Where a cell of this row starts; where the file lacks the column, the row.
  FilePosition place(std::size_t column) const;

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  struct Cell {
    std::string text;
    std::uint64_t column = 1;
  };

  hal::files::TextPlace this_line() const { return {name_, lines_.line_number(), lines_.line()}; }
  bool go_to_content();
  void read_header(const hal::files::TextPlace& line);
  void read_row(const hal::files::TextPlace& line);
  std::size_t column_named(const std::string& name, const hal::files::TextPlace& line,
                           std::size_t offset) const;
  std::string column_names() const;

  std::string name_;
  std::vector<CsvColumn> columns_;
  hal::files::LineBuffer lines_;
  hal::files::CsvDialect dialect_;
  std::vector<std::size_t> fields_;  ///< for each column the number of its field
  std::vector<Cell> row_;
  FilePosition header_end_;
  std::uint64_t line_ = 0;
};

/// A name of the kind that its column says: visible characters, at least one. @throws InputError
std::string name_in_row(const CsvTable& table, std::size_t column);

/// A number of cycles: above 0. @throws InputError
double cycles_in_row(const CsvTable& table, std::size_t column);

}  // namespace host_sim
