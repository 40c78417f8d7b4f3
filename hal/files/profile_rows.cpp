#include "hal/files/profile_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "hal/files/csv.hpp"
#include "hal/files/text.hpp"

namespace hal::files {
namespace {

/// @throws InputError for anything but a number whose column is within its range
double checked_value(const CsvLine& text, const CsvDialect& dialect, const ProfileField& field,
                     const TextPlace& line) {
  const auto fail = [&](std::string_view what, std::string_view accepted) {
    line.fail(text.offset(), fmt::format("{} is {}", printable(field.name), what), accepted);
  };
  if (text.broken()) {
    fail("quoted, but the field does not end with its quote",
         field.passed_over() ? "a field with both quotes, or without"
                             : "a finite decimal number without spaces");
  }
  if (field.passed_over()) {
    return 0;
  }
  const auto number = finite_number(text.text());
  if (!number) {
    const NoNumber none = no_number(text.text(), dialect);
    fail(none.found, none.accepted);
  }
  const ProfileColumn& column = profile_columns()[field.id];
  const double value = field.converts() ? *number * field.scale + field.offset : *number;
  if (!(value >= column.minimum) || !(value <= column.maximum)) {
    fail(field.name == column.name && value == *number
             ? in_quotes(text.text()) + ", out of range"
             : fmt::format("{}, and {} becomes {}, out of range", in_quotes(text.text()),
                           column.name, value),
         fmt::format("{}..{} {}", column.minimum, column.maximum, column.unit));
  }
  return value;
}

/// Of a row with more fields than the header.
[[noreturn]] void fail_too_long(const TextPlace& line, const CsvDialect& dialect,
                                std::size_t offset, std::size_t expected) {
  std::size_t count = 0;
  for (CsvLine fields(line.text, dialect); fields.next();) {
    ++count;
  }
  if (dialect.delimiter == ',' && count == 2 * expected) {
    line.fail(offset, fmt::format("{} fields, as decimal commas make them of {}", count, expected),
              "decimal points, or fields between semicolons or tabs");
  }
  line.fail(offset, "more fields than the header",
            fmt::format("{} fields, as in the header", expected));
}

}  // namespace

void refuse_nul(const TextPlace& line) {
  const std::size_t nul = line.text.find('\0');
  if (nul != std::string_view::npos) {
    line.fail(nul, "a NUL byte", "UTF-8 text");
  }
}

ProfileLayout read_profile_header(LineBuffer& lines, std::string_view name,
                                  std::string_view accepted, const ProfileHeaderParser& layout_of) {
  const auto this_line = [&] { return TextPlace{name, lines.line_number(), lines.line()}; };
  const auto go_to_content = [&](std::string_view needed, std::string_view nothing) {
    while (lines.fill()) {
      if (*lines.position() != '#') {
        return;
      }
      refuse_nul(this_line());
      lines.next_line(lines.line_end());
    }
    throw InputError(name, 0, 0, nothing, needed);
  };
  go_to_content(accepted, "the file is empty");
  const TextPlace line = this_line();
  refuse_nul(line);
  ProfileLayout layout = layout_of(line);
  lines.next_line(lines.line_end());
  go_to_content("at least one row after the header", "no rows");
  return layout;
}

ProfileRowParser::ProfileRowParser(ProfileLayout layout) : layout_(std::move(layout)) {
  for (const ProfileField& field : layout_.fields) {
    // What is passed over has any range.
    const ProfileColumn& column = profile_columns()[field.passed_over() ? kTime : field.id];
    columns_.push_back({field.id, field.passed_over(), field.converts(), field.scale, field.offset,
                        column.minimum, column.maximum});
  }
}

void ProfileRowParser::by_the_book(const TextPlace& line, double last_time_s,
                                   Values& values) const {
  refuse_nul(line);
  const std::size_t expected = layout_.fields.size();
  const std::string accepted = fmt::format("{} fields, as in the header", expected);
  if (line.text.empty()) {
    line.fail(0, "an empty line", accepted);
  }
  CsvLine fields(line.text, layout_.dialect);
  std::size_t count = 0;
  std::size_t time_offset = 0;
  while (fields.next()) {
    if (count == expected) {
      fail_too_long(line, layout_.dialect, fields.offset(), expected);
    }
    const ProfileField& field = layout_.fields[count];
    if (field.id == kTime) {
      time_offset = fields.offset();
    }
    values[field.id] = checked_value(fields, layout_.dialect, field, line);
    ++count;
  }
  if (count != expected) {
    line.fail(line.text.size(), fmt::format("{} fields only", count), accepted);
  }
  if (!(values[kTime] > last_time_s)) {
    line.fail(time_offset,
              values[kTime] == last_time_s
                  ? fmt::format("time stands still at {} s", last_time_s)
                  : fmt::format("time runs back from {} s to {} s", last_time_s, values[kTime]),
              "time that increases from row to row");
  }
}

ProfileRows::ProfileRows(std::unique_ptr<ByteSource> source, std::string_view name,
                         std::string_view accepted, const ProfileHeaderParser& layout_of)
    : name_(name),
      lines_(std::move(source), name_),
      parser_(read_profile_header(lines_, name_, accepted, layout_of)) {}

bool ProfileRows::next() {
  while (lines_.fill()) {
    if (*lines_.position() == '#') {
      refuse_nul(this_line());
      lines_.next_line(lines_.line_end());
      continue;
    }
    const char* line_end =
        parser_.plain(lines_.position(), lines_.lines_end(), last_time_s_, values_);
    if (line_end == nullptr) {
      parser_.by_the_book(this_line(), last_time_s_, values_);
      line_end = lines_.line_end();
    }
    lines_.next_line(line_end);
    last_time_s_ = values_[kTime];
    return true;
  }
  return false;
}

}  // namespace hal::files
