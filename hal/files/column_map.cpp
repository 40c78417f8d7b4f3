#include "hal/files/column_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "hal/files/nearest.hpp"
#include "hal/files/profile_columns.hpp"
#include "hal/files/text.hpp"

namespace hal::files {
namespace {

/// One of it is scale of the channel's own unit, from offset on.
struct SourceUnit {
  std::string_view name;
  double scale = 1;
  double offset = 0;
};

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTurn = 2 * std::numbers::pi;

std::vector<SourceUnit> units_of(ProfileColumnId channel, bool rate) {
  switch (channel) {
    case kTime:
      return {{"s"}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}};
    case kInputTensionColumn:
    case kOutputTensionColumn:
      return {{"N"}, {"mN", 1e-3}, {"kN", 1e3}, {"kgf", 9.80665}, {"lbf", 4.4482216152605}};
    case kMotorCurrentColumn:
      return {{"A"}, {"mA", 1e-3}};
    case kTendonVelocity:
      return rate ? std::vector<SourceUnit>{{"m"},   {"cm", 1e-2},     {"mm", 1e-3},
                                            {"rad"}, {"deg", kDegree}, {"rev", kTurn}}
                  : std::vector<SourceUnit>{{"m/s"},   {"cm/s", 1e-2},     {"mm/s", 1e-3},
                                            {"rad/s"}, {"deg/s", kDegree}, {"rpm", kTurn / 60}};
    case kBendAngle:
      return {{"deg"}, {"rad", 1 / kDegree}, {"rev", 360}};
    case kMotorAngle:
      return {{"rad"}, {"deg", kDegree}, {"rev", kTurn}};
    case kSheathTemperature:
    case kWindingTemperature:
      return {{"C"}, {"K", 1, -273.15}};
    case kProfileColumnCount:
      break;
  }
  return {};
}

constexpr std::string_view kForm =
    "[-][FACTOR*]COLUMN[ in UNIT][+OFFSET]=CHANNEL, the column in double quotes where it holds "
    "more "
    "than letters, digits and _; rate(COLUMN[ in UNIT]) is differentiated by time";

bool is_part_of_word(unsigned char c) {
  return c >= 0x80 || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
         (c >= 'A' && c <= 'Z');
}

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// A word and more behind a blank or bracket, without an operator: `Force [N]`, `motor angle`.
bool is_bare_name(std::string_view text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(), is_part_of_word);
  const std::string_view behind(end, text.end());
  return end != text.begin() && !behind.empty() && behind.find_first_of("\"*+") == behind.npos &&
         !without_blanks(behind).starts_with('-') && !behind.starts_with(" in ") &&
         !text.starts_with("rate(");
}

/// Takes a map apart: the channel behind the last =, the rest from the left to the right.
class MapReader {
 public:
  explicit MapReader(std::string_view text) : text_(text) {}

  ColumnMap read() {
    ColumnMap map;
    const std::size_t equals = text_.rfind('=');
    if (equals == std::string_view::npos) {
      fail("no = in front of a channel");
    }
    map.channel = channel(without_blanks(text_.substr(equals + 1)));
    rest_ = without_blanks(text_.substr(0, equals));
    if (is_bare_name(rest_)) {
      map.column = rest_;
      return map;
    }
    const double sign = take('-') ? -1 : 1;
    const double factor = number_before('*').value_or(1);
    map.rate = take("rate(");
    map.column = column();
    const SourceUnit unit = unit_of(map.channel, map.rate);
    if (map.rate && !take(')')) {
      fail("no ) behind the column");
    }
    map.scale = sign * factor * unit.scale;
    map.offset = sign * factor * unit.offset + offset();
    if (map.rate && map.offset != 0) {
      fail("a rate with an offset");
    }
    if (map.scale == 0 || !std::isfinite(map.scale) || !std::isfinite(map.offset)) {
      fail("a factor or offset that says nothing");
    }
    return map;
  }

 private:
  [[noreturn]] void fail(std::string_view found, std::string_view accepted = kForm) const {
    throw std::invalid_argument(
        fmt::format("{}: {}; accepted: {}", in_quotes(text_), found, accepted));
  }

  void skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  bool take(std::string_view token) {
    skip_spaces();
    const bool there = rest_.starts_with(token);
    rest_.remove_prefix(there ? token.size() : 0);
    return there;
  }
  bool take(char token) { return take(std::string_view(&token, 1)); }

  std::string_view word() {
    skip_spaces();
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_part_of_word);
    const std::string_view found(rest_.begin(), end);
    rest_.remove_prefix(found.size());
    return found;
  }

  ProfileColumnId channel(std::string_view name) const {
    const auto columns = profile_columns();
    const auto known =
        std::find_if(columns.begin(), columns.end(),
                     [&](const ProfileColumn& column) { return column.name == name; });
    if (known == columns.end()) {
      std::vector<std::string> names;
      std::transform(columns.begin(), columns.end(), std::back_inserter(names),
                     [](const ProfileColumn& column) { return std::string(column.name); });
      const auto meant = nearest(std::string(name), names);
      fail(fmt::format("unknown channel {}", in_quotes(name)),
           meant ? *meant : profile_column_names());
    }
    return static_cast<ProfileColumnId>(known - columns.begin());
  }

  std::optional<double> number_before(char end) {
    skip_spaces();
    const char* position = rest_.data();
    double value = 0;
    if (!parse_number(position, rest_.data() + rest_.size(), value)) {
      return {};
    }
    const std::string_view before = rest_;
    rest_.remove_prefix(static_cast<std::size_t>(position - rest_.data()));
    if (!take(end)) {
      rest_ = before;  // the name of a column may begin with digits
      return {};
    }
    return value;
  }

  std::string column() {
    std::string name;
    if (take('"')) {
      const std::size_t quote = rest_.find('"');
      if (quote == std::string_view::npos) {
        fail("a column that does not end with its quote");
      }
      name = rest_.substr(0, quote);
      rest_.remove_prefix(quote + 1);
    } else {
      name = word();
    }
    if (name.empty()) {
      fail("no column");
    }
    return name;
  }

  SourceUnit unit_of(ProfileColumnId channel, bool rate) {
    if (!take("in ")) {
      return {};
    }
    skip_spaces();
    const std::string_view name = rest_.substr(0, rest_.find_first_of(" )+-"));
    rest_.remove_prefix(name.size());
    const std::vector<SourceUnit> units = units_of(channel, rate);
    const auto unit = std::find_if(units.begin(), units.end(),
                                   [&](const SourceUnit& known) { return known.name == name; });
    if (unit == units.end()) {
      std::vector<std::string_view> names;
      std::transform(units.begin(), units.end(), std::back_inserter(names),
                     [](const SourceUnit& known) { return known.name; });
      fail(fmt::format("unknown unit {}", in_quotes(name)),
           fmt::format("{}", fmt::join(names, ", ")));
    }
    return *unit;
  }

  double offset() {
    skip_spaces();
    if (rest_.empty()) {
      return 0;
    }
    const double sign = take('-') ? -1 : take('+') ? 1 : 0;
    skip_spaces();
    const char* position = rest_.data();
    const char* const end = position + rest_.size();
    double value = 0;
    if (sign == 0 || !parse_number(position, end, value) || position != end) {
      fail(fmt::format("{} at the end", in_quotes(rest_)));
    }
    return sign * value;
  }

  std::string_view text_;
  std::string_view rest_;
};

}  // namespace

ColumnMap column_map(std::string_view text) {
  return MapReader(text).read();
}

std::optional<std::string> map_of_unit(std::string_view column, std::string_view unit,
                                       ProfileColumnId channel) {
  std::string slashed(unit);
  std::replace(slashed.begin(), slashed.end(), '_', '/');
  const std::vector<SourceUnit> units = units_of(channel, false);
  const bool known = std::any_of(units.begin(), units.end(),
                                 [&](const SourceUnit& one) { return one.name == slashed; });
  const bool turns = channel == kTendonVelocity && slashed.find('m') == std::string::npos;
  if (!known || turns || slashed == "rpm") {  // turns need a radius
    return std::nullopt;
  }
  return fmt::format("{} in {}={}", column_word(column), slashed, profile_columns()[channel].name);
}

std::string column_word(std::string_view column) {
  return !column.empty() && std::all_of(column.begin(), column.end(), is_part_of_word)
             ? std::string(column)
             : fmt::format("\"{}\"", column);
}

}  // namespace hal::files
