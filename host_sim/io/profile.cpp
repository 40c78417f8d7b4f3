#include "host_sim/io/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/io/csv_line.hpp"
#include "host_sim/io/line_buffer.hpp"
#include "host_sim/io/number.hpp"
#include "host_sim/io/profile_columns.hpp"
#include "host_sim/io/profile_header.hpp"
#include "host_sim/io/text_place.hpp"

namespace host_sim {
namespace {

constexpr std::string_view kAcceptedFile =
    "a CSV file with time_s and one of input_tension_N, motor_current_A, output_tension_N with "
    "tendon_velocity_m_s, or - for standard input";
constexpr std::array<std::string_view, 3> kKindNames{"input_tension", "motor_current",
                                                     "output_tension"};

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

std::string_view to_string(InputKind kind) {
  return kKindNames.at(static_cast<std::size_t>(kind));
}

std::optional<InputKind> input_kind_from(std::string_view name) {
  const auto* const found = std::find(kKindNames.begin(), kKindNames.end(), name);
  if (found == kKindNames.end()) {
    return std::nullopt;
  }
  return static_cast<InputKind>(found - kKindNames.begin());
}

class ProfileReader::Impl {
 public:
  Impl(std::unique_ptr<ByteSource> source, std::string_view name, const ProfileOptions& options)
      : name_(name), lines_(std::move(source), name_) {
    go_to_content(kAcceptedFile, "the file is empty");
    const TextPlace line = this_line();
    refuse_nul(line);
    header_ = parse_profile_header(line, options);
    lines_.next_line(lines_.line_end());
    go_to_content("at least one row after the header", "no rows");
    choose_value_column();
  }

  std::size_t read(std::span<ProfileRow> rows) {
    std::size_t count = 0;
    while (count < rows.size() && lines_.fill()) {
      if (*lines_.position() == '#') {
        skip_comment();
        continue;
      }
      if (!read_plain_row()) {
        read_row();
      }
      last_time_s_ = values_[kTime];
      rows[count] = {values_[kTime], values_[value_column_], values_[velocity_column_],
                     values_[bend_column_]};
      ++count;
    }
    return count;
  }

  const ProfileHeader& header() const noexcept { return header_; }
  const LineBuffer& lines() const noexcept { return lines_; }

 private:
  static constexpr unsigned kAbsent = kProfileColumnCount;

  TextPlace this_line() const { return {name_, lines_.line_number(), lines_.line()}; }

  void skip_comment() {
    refuse_nul(this_line());
    lines_.next_line(lines_.line_end());
  }

  void go_to_content(std::string_view accepted, std::string_view nothing) {
    while (lines_.fill()) {
      if (*lines_.position() != '#') {
        return;
      }
      skip_comment();
    }
    throw InputError(name_, 0, 0, nothing, accepted);
  }

  void choose_value_column() {
    switch (header_.kind) {
      case InputKind::kInputTension:
        value_column_ = kInputTensionColumn;
        break;
      case InputKind::kMotorCurrent:
        value_column_ = kMotorCurrentColumn;
        break;
      case InputKind::kOutputTension:
        value_column_ = kOutputTensionColumn;
        velocity_column_ = kTendonVelocity;
        break;
    }
    if (header_.has_bend_angle) {
      bend_column_ = kBendAngle;
    }
  }

  // The common row: numbers, quoted or not, all right. False, with nothing consumed, for any other.
  bool read_plain_row() {
    const char* at = lines_.position();
    const char* const end = lines_.lines_end();
    const std::size_t last = header_.columns.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const ProfileColumnId id = header_.columns[i];
      const ProfileColumn& column = profile_columns()[id];
      const bool has_quotes = *at == '"';
      at += has_quotes ? 1 : 0;
      double value = 0.0;
      if (!parse_number(at, end, value) || !(value >= column.minimum) ||
          !(value <= column.maximum) || (has_quotes && *at++ != '"')) {
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
  void read_row() {
    const TextPlace line = this_line();
    refuse_nul(line);
    const std::size_t expected = header_.columns.size();
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
      const ProfileColumnId id = header_.columns[count];
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

  std::string name_;
  LineBuffer lines_;
  ProfileHeader header_{};
  unsigned value_column_ = kAbsent;
  unsigned velocity_column_ = kAbsent;
  unsigned bend_column_ = kAbsent;
  std::array<double, kProfileColumnCount + 1> values_{};
  double last_time_s_ = -std::numeric_limits<double>::infinity();
};

ProfileReader::ProfileReader(const std::filesystem::path& path, ProfileOptions options)
    : ProfileReader(open_source(path, kAcceptedFile),
                    path == "-" ? std::string("standard input") : path.string(), options) {}

ProfileReader::ProfileReader(std::unique_ptr<ByteSource> source, std::string_view name,
                             ProfileOptions options)
    : impl_(std::make_unique<Impl>(std::move(source), name, options)) {}

ProfileReader::ProfileReader(ProfileReader&&) noexcept = default;
ProfileReader& ProfileReader::operator=(ProfileReader&&) noexcept = default;
ProfileReader::~ProfileReader() = default;

InputKind ProfileReader::kind() const noexcept {
  return impl_->header().kind;
}

bool ProfileReader::has_bend_angle() const noexcept {
  return impl_->header().has_bend_angle;
}

std::size_t ProfileReader::read(std::span<ProfileRow> rows) {
  return impl_->read(rows);
}

std::uint64_t ProfileReader::bytes_read() const noexcept {
  return impl_->lines().bytes_read();
}

std::uint64_t ProfileReader::bytes_total() const noexcept {
  return impl_->lines().bytes_total();
}

}  // namespace host_sim
