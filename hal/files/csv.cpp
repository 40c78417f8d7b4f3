#include "hal/files/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hal/files/text.hpp"

namespace hal::files {
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

bool has_outside_of_quotes(std::string_view line, std::string_view text) {
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    quoted = quoted != (line[at] == '"');
    if (!quoted && line.substr(at).starts_with(text)) {
      return true;
    }
  }
  return false;
}

}  // namespace

CsvDialect dialect_of(std::string_view header) {
  CsvDialect dialect;
  for (const char delimiter : {'\t', ';'}) {
    if (dialect.delimiter == ',' && has_outside_of_quotes(header, {&delimiter, 1})) {
      dialect.delimiter = delimiter;
    }
  }
  dialect.blanks = has_outside_of_quotes(header, std::string{dialect.delimiter, ' '});
  return dialect;
}

bool CsvLine::next() {
  if (at_end_) {
    return false;
  }
  while (dialect_.blanks && next_ < line_.size() && line_[next_] == ' ') {
    ++next_;
  }
  offset_ = next_;
  broken_ = false;
  text_.clear();
  if (next_ < line_.size() && line_[next_] == '"') {
    read_quoted();
  }
  const std::size_t end = std::min(line_.find(dialect_.delimiter, next_), line_.size());
  const std::string_view rest = line_.substr(next_, end - next_);
  if (offset_ < line_.size() && line_[offset_] == '"') {
    broken_ = broken_ || !rest.empty();
  } else {
    text_ = rest;
  }
  at_end_ = end == line_.size();
  next_ = end + 1;
  return true;
}

void CsvLine::read_quoted() {
  std::size_t at = next_ + 1;
  for (;;) {
    const std::size_t quote = line_.find('"', at);
    if (quote == std::string_view::npos) {
      broken_ = true;
      next_ = line_.size();
      return;
    }
    text_ += line_.substr(at, quote - at);
    if (quote + 1 == line_.size() || line_[quote + 1] != '"') {
      next_ = quote + 1;
      return;
    }
    text_ += '"';
    at = quote + 2;
  }
}

std::optional<double> finite_number(std::string_view field) {
  const char* position = field.data();
  const char* const end = position + field.size();
  double value = 0;
  if (!parse_number(position, end, value) || position != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

NoNumber no_number(std::string_view field, const CsvDialect& dialect) {
  if (field.empty()) {
    return {"empty", "a finite decimal number without spaces"};
  }
  std::string point(field);
  std::replace(point.begin(), point.end(), ',', '.');
  if (point != field && finite_number(point)) {
    return {
        in_quotes(field) + ", with a decimal comma",
        dialect.delimiter == ','
            ? fmt::format("decimal points, {}: write the file anew with them", in_quotes(point))
            : fmt::format("decimal points, {}: sed 's/,/./g' FILE writes them", in_quotes(point))};
  }
  return {in_quotes(field) + ", not a finite number", "a finite decimal number without spaces"};
}

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

}  // namespace hal::files
