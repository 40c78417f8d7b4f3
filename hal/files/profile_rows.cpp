#include "hal/files/profile_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "hal/files/csv.hpp"
#include "hal/files/text.hpp"

namespace hal::files {
namespace {

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

}  // namespace

void refuse_nul(const TextPlace& line) {
  const std::size_t nul = line.text.find('\0');
  if (nul != std::string_view::npos) {
    line.fail(nul, "a NUL byte", "UTF-8 text");
  }
}

std::vector<ProfileColumnId> read_profile_header(LineBuffer& lines, std::string_view name,
                                                 std::string_view accepted,
                                                 const ProfileHeaderParser& columns_of) {
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
  std::vector<ProfileColumnId> columns = columns_of(line);
  lines.next_line(lines.line_end());
  go_to_content("at least one row after the header", "no rows");
  return columns;
}

ProfileRowParser::ProfileRowParser(std::vector<ProfileColumnId> columns)
    : columns_(std::move(columns)) {
  for (const ProfileColumnId id : columns_) {
    ranges_.push_back({id, profile_columns()[id].minimum, profile_columns()[id].maximum});
  }
}

void ProfileRowParser::by_the_book(const TextPlace& line, double last_time_s,
                                   Values& values) const {
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
    values[id] = checked_value(fields, profile_columns()[id], line);
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
                         std::string_view accepted, const ProfileHeaderParser& columns_of)
    : name_(name),
      lines_(std::move(source), name_),
      parser_(read_profile_header(lines_, name_, accepted, columns_of)) {}

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
