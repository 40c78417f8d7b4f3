#include "host_sim/campaign/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "hal/files/nearest.hpp"
#include "hal/files/text.hpp"

namespace host_sim {

using hal::files::ByteSource;
using hal::files::character_count;
using hal::files::CsvLine;
using hal::files::in_quotes;
using hal::files::InputError;
using hal::files::NumberRange;
using hal::files::other_unit;
using hal::files::printable;
using hal::files::range_text;
using hal::files::TextPlace;

namespace {

const std::string kNothing;

void refuse_nul(const TextPlace& line) {
  const std::size_t nul = line.text.find('\0');
  if (nul != std::string_view::npos) {
    line.fail(nul, "a NUL byte", "UTF-8 text");
  }
}

}  // namespace

CsvTable::CsvTable(std::unique_ptr<ByteSource> source, std::string_view name,
                   std::span<const CsvColumn> columns)
    : name_(name),
      columns_(columns.begin(), columns.end()),
      lines_(std::move(source), name_),
      fields_(columns.size(), kAbsent) {
  if (!go_to_content()) {
    throw InputError(name_, 0, 0, "the file is empty", "a CSV file with " + column_names());
  }
  read_header(this_line());
  lines_.next_line(lines_.line_end());
  if (!go_to_content()) {
    throw InputError(name_, 0, 0, "no rows", "at least one row after the header");
  }
}

bool CsvTable::go_to_content() {
  while (lines_.fill()) {
    refuse_nul(this_line());
    if (*lines_.position() != '#') {
      return true;
    }
    lines_.next_line(lines_.line_end());
  }
  return false;
}

void CsvTable::read_header(const TextPlace& line) {
  if (line.text.empty()) {
    line.fail(0, "an empty line in place of the header", column_names());
  }
  dialect_ = hal::files::dialect_of(line.text);
  CsvLine fields(line.text, dialect_);
  for (std::size_t field = 0; fields.next(); ++field) {
    if (fields.broken()) {
      line.fail(fields.offset(), "a quoted name that does not end with its quote", column_names());
    }
    const std::size_t column = column_named(fields.text(), line, fields.offset());
    if (has(column)) {
      line.fail(fields.offset(), fmt::format("column {} a second time", columns_[column].name),
                "each column once");
    }
    fields_[column] = field;
    row_.emplace_back();
  }
  header_end_ = {name_, line.number, character_count(line.text) + 1};
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].required && !has(column)) {
      header_end_.fail(fmt::format("no column {}", columns_[column].name), column_names());
    }
  }
}

std::size_t CsvTable::column_named(const std::string& name, const TextPlace& line,
                                   std::size_t offset) const {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].name == name) {
      return column;
    }
  }
  for (const CsvColumn& column : columns_) {
    if (const auto unit = other_unit(name, column.name, column.unit)) {
      line.fail(offset,
                unit->empty() ? fmt::format("column {} without its unit", in_quotes(name))
                              : fmt::format("unknown unit {} of column {}", in_quotes(*unit),
                                            in_quotes(name)),
                column.name);
    }
  }
  std::vector<std::string> known;
  std::ranges::transform(columns_, std::back_inserter(known),
                         [](const CsvColumn& column) { return std::string(column.name); });
  const auto meant = hal::files::nearest(name, known);
  line.fail(offset,
            fmt::format("unknown column {}{}", in_quotes(name),
                        meant ? fmt::format(", nearest to {}", *meant) : ""),
            column_names());
}

bool CsvTable::next() {
  if (!go_to_content()) {
    return false;
  }
  read_row(this_line());
  lines_.next_line(lines_.line_end());
  return true;
}

void CsvTable::read_row(const TextPlace& line) {
  const std::string accepted = fmt::format("{} fields, as in the header", row_.size());
  if (line.text.empty()) {
    line.fail(0, "an empty line", accepted);
  }
  CsvLine fields(line.text, dialect_);
  std::size_t count = 0;
  while (fields.next()) {
    if (count == row_.size()) {
      line.fail(fields.offset(), "more fields than the header", accepted);
    }
    if (fields.broken()) {
      line.fail(fields.offset(), "a quoted field that does not end with its quote",
                "a field with both quotes, or without");
    }
    row_[count].text = fields.text();
    row_[count].column = character_count(line.text.substr(0, fields.offset())) + 1;
    ++count;
  }
  if (count != row_.size()) {
    line.fail(line.text.size(), fmt::format("{} fields only", count), accepted);
  }
  line_ = line.number;
}

const std::string& CsvTable::cell(std::size_t column) const {
  return has(column) ? row_[fields_[column]].text : kNothing;
}

const std::string& CsvTable::text(std::size_t column) const {
  const std::string& text = cell(column);
  if (printable(text) != text) {
    place(column).fail(fmt::format("{} is {}", columns_[column].name, in_quotes(text)),
                       "visible characters in UTF-8");
  }
  return text;
}

double CsvTable::number(std::size_t column, const NumberRange& range) const {
  const std::string_view name = columns_[column].name;
  const std::string& text = cell(column);
  const auto value = hal::files::finite_number(text);
  if (!value) {
    const auto none = hal::files::no_number(text, dialect_);
    place(column).fail(fmt::format("{} is {}", name, none.found), none.accepted);
  }
  if (!range.contains(*value)) {
    place(column).fail(fmt::format("{} is {}, out of range", name, in_quotes(text)),
                       range_text(range));
  }
  return *value;
}

FilePosition CsvTable::place(std::size_t column) const {
  return {name_, line_, has(column) ? row_[fields_[column]].column : 1};
}

std::string CsvTable::column_names() const {
  std::string names;
  for (const CsvColumn& column : columns_) {
    names += names.empty() ? "" : ", ";
    names += column.name;
  }
  return names;
}

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
