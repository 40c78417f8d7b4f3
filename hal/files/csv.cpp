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

}  // namespace

bool CsvLine::next() {
  if (at_end_) {
    return false;
  }
  offset_ = next_;
  broken_ = false;
  text_.clear();
  if (next_ < line_.size() && line_[next_] == '"') {
    read_quoted();
  }
  const std::size_t end = std::min(line_.find(delimiter_, next_), line_.size());
  const std::string_view rest = line_.substr(next_, end - next_);
  if (line_.substr(offset_).starts_with('"')) {
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
