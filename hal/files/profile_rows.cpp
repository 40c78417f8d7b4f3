#include "hal/files/profile_rows.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "hal/files/csv.hpp"
#include "hal/files/text.hpp"

namespace hal::files {
namespace {

constexpr std::array<ProfileColumn, kProfileColumnCount> kColumns{{
    {"time_s", "s", -1e12, 1e12},
    {"input_tension_N", "N", -1e6, 1e6},
    {"motor_current_A", "A", -1e6, 1e6},
    {"output_tension_N", "N", -1e6, 1e6},
    {"tendon_velocity_m_s", "m_s", -1000.0, 1000.0},
    {"bend_angle_deg", "deg", 0.0, 1800.0},
    {"motor_angle_rad", "rad", -1e12, 1e12},
    {"sheath_temperature_C", "C", -273.15, 10000.0},
    {"winding_temperature_C", "C", -273.15, 10000.0},
}};

std::string_view name_of(ProfileColumnId id) {
  return profile_columns()[id].name;
}

ProfileColumnId column_named(const std::string& name, const TextPlace& line, std::size_t offset) {
  unsigned id = 0;
  for (const ProfileColumn& column : profile_columns()) {
    if (name == column.name) {
      return static_cast<ProfileColumnId>(id);
    }
    ++id;
  }
  for (const ProfileColumn& column : profile_columns()) {
    if (const auto unit = other_unit(name, column.name, column.unit)) {
      line.fail(offset,
                unit->empty() ? fmt::format("column {} without its unit", in_quotes(name))
                              : fmt::format("unknown unit {} of column {}", in_quotes(*unit),
                                            in_quotes(name)),
                column.name);
    }
  }
  line.fail(offset, fmt::format("unknown column {}", in_quotes(name)), profile_column_names());
}

[[noreturn]] void fail_missing(const TextPlace& line, std::string_view column,
                               std::string_view needed) {
  line.fail(line.text.size(), fmt::format("no column {}", column), needed);
}

double checked_value(const CsvLine& field, const ProfileColumn& column, const TextPlace& line) {
  const auto fail = [&](std::string_view what, std::string_view accepted) {
    line.fail(field.offset(), fmt::format("{} is {}", column.name, what), accepted);
  };
  constexpr std::string_view kNumber = "a finite decimal number without spaces";
  const std::string& text = field.text();
  if (field.broken()) {
    fail("quoted, but the field does not end with its quote", kNumber);
  }
  if (text.empty()) {
    fail("empty", kNumber);
  }
  const char* position = text.data();
  const char* const end = position + text.size();
  double value = 0.0;
  if (!parse_number(position, end, value) || position != end || !std::isfinite(value)) {
    fail(in_quotes(text) + ", not a finite number", kNumber);
  }
  if (value < column.minimum || value > column.maximum) {
    fail(in_quotes(text) + ", out of range",
         fmt::format("{}..{} {}", column.minimum, column.maximum, column.unit));
  }
  return value;
}

void refuse_nul(const TextPlace& line) {
  const std::size_t nul = line.text.find('\0');
  if (nul != std::string_view::npos) {
    line.fail(nul, "a NUL byte", "UTF-8 text");
  }
}

}  // namespace

std::span<const ProfileColumn, kProfileColumnCount> profile_columns() {
  return kColumns;
}

std::string profile_column_names() {
  std::string names;
  for (const ProfileColumn& column : kColumns) {
    if (!names.empty()) {
      names += ", ";
    }
    names += column.name;
  }
  return names;
}

std::vector<ProfileColumnId> parse_profile_columns(const TextPlace& line, std::string_view needed) {
  if (line.text.empty()) {
    line.fail(0, "an empty line in place of the header", needed);
  }
  std::vector<ProfileColumnId> columns;
  ProfileChannels present;
  CsvLine fields(line.text);
  while (fields.next()) {
    if (fields.broken()) {
      line.fail(fields.offset(), "a quoted name that does not end with its quote",
                profile_column_names());
    }
    const ProfileColumnId id = column_named(fields.text(), line, fields.offset());
    if (present[id]) {
      line.fail(fields.offset(), fmt::format("column {} a second time", name_of(id)),
                "each column once");
    }
    present.set(id);
    columns.push_back(id);
  }
  if (!present[kTime]) {
    fail_missing(line, name_of(kTime), needed);
  }
  return columns;
}

ProfileRows::ProfileRows(std::unique_ptr<ByteSource> source, std::string_view name,
                         std::string_view accepted, const HeaderParser& columns_of)
    : name_(name), lines_(std::move(source), name_) {
  go_to_content(accepted, "the file is empty");
  const TextPlace line = this_line();
  refuse_nul(line);
  columns_ = columns_of(line);
  lines_.next_line(lines_.line_end());
  go_to_content("at least one row after the header", "no rows");
}

bool ProfileRows::next() {
  while (lines_.fill()) {
    if (*lines_.position() == '#') {
      skip_comment();
      continue;
    }
    if (!read_plain_row()) {
      read_row();
    }
    last_time_s_ = values_[kTime];
    return true;
  }
  return false;
}

void ProfileRows::skip_comment() {
  refuse_nul(this_line());
  lines_.next_line(lines_.line_end());
}

void ProfileRows::go_to_content(std::string_view accepted, std::string_view nothing) {
  while (lines_.fill()) {
    if (*lines_.position() != '#') {
      return;
    }
    skip_comment();
  }
  throw InputError(name_, 0, 0, nothing, accepted);
}

// The common row: numbers, quoted or not, all right. False, with nothing consumed, for any other.
bool ProfileRows::read_plain_row() {
  const char* at = lines_.position();
  const char* const end = lines_.lines_end();
  const std::size_t last = columns_.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const ProfileColumnId id = columns_[i];
    const ProfileColumn& column = profile_columns()[id];
    const bool has_quotes = *at == '"';
    at += has_quotes ? 1 : 0;
    double value = 0.0;
    if (!parse_number(at, end, value) || !(value >= column.minimum) || !(value <= column.maximum) ||
        (has_quotes && *at++ != '"')) {
      return false;
    }
    values_[id] = value;
    if (i != last && *at++ != ',') {
      return false;
    }
  }
  if (*at == '\r') {
    ++at;
  }
  if (*at != '\n' || !(values_[kTime] > last_time_s_)) {
    return false;
  }
  lines_.next_line(at);
  return true;
}

// Any row, by the book; throws InputError if there is something wrong with it.
void ProfileRows::read_row() {
  const TextPlace line = this_line();
  refuse_nul(line);
  const std::size_t expected = columns_.size();
  const std::string accepted = fmt::format("{} fields, as in the header", expected);
  if (line.text.empty()) {
    line.fail(0, "an empty line", accepted);
  }
  CsvLine fields(line.text);
  std::size_t count = 0;
  std::size_t time_offset = 0;
  while (fields.next()) {
    if (count == expected) {
      line.fail(fields.offset(), "more fields than the header", accepted);
    }
    const ProfileColumnId id = columns_[count];
    if (id == kTime) {
      time_offset = fields.offset();
    }
    values_[id] = checked_value(fields, profile_columns()[id], line);
    ++count;
  }
  if (count != expected) {
    line.fail(line.text.size(), fmt::format("{} fields only", count), accepted);
  }
  if (!(values_[kTime] > last_time_s_)) {
    line.fail(time_offset,
              values_[kTime] == last_time_s_
                  ? fmt::format("time stands still at {} s", last_time_s_)
                  : fmt::format("time runs back from {} s to {} s", last_time_s_, values_[kTime]),
              "time that increases from row to row");
  }
  lines_.next_line(lines_.line_end());
}

}  // namespace hal::files
