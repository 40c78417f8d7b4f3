#include "host_sim/recording/import_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "hal/files/csv.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/text.hpp"
#include "host_sim/recording/recording_files.hpp"

namespace host_sim::recording {

using hal::files::ByteSource;
using hal::files::CsvLine;
using hal::files::in_quotes;
using hal::files::InputError;
using enum hal::files::ProfileColumnId;
using hal::files::LineBuffer;
using hal::files::NumberRange;
using hal::files::parse_number;
using hal::files::profile_column_names;
using hal::files::profile_columns;
using hal::files::ProfileColumn;
using hal::files::ProfileColumnId;
using hal::files::range_text;
using hal::files::TextPlace;

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
    "CHANNEL=[-][FACTOR*]COLUMN[ in UNIT][+OFFSET], with rate(COLUMN[ in UNIT]) for a column that "
    "is to "
    "be differentiated by time";

/// Takes a map apart from the left to the right.
class MapReader {
 public:
  explicit MapReader(std::string_view text) : text_(text), rest_(text) {}

  ColumnMap read() {
    ColumnMap map;
    map.channel = channel();
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
    const auto is_part = [](unsigned char c) {
      return c >= 0x80 || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
             (c >= 'A' && c <= 'Z');
    };
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_part);
    const std::string_view found(rest_.begin(), end);
    rest_.remove_prefix(found.size());
    return found;
  }

  ProfileColumnId channel() {
    const std::string_view name = word();
    const auto columns = profile_columns();
    const auto known =
        std::find_if(columns.begin(), columns.end(),
                     [&](const ProfileColumn& column) { return column.name == name; });
    if (known == columns.end()) {
      fail(fmt::format("unknown channel {}", in_quotes(name)), profile_column_names());
    }
    if (!take('=')) {
      fail("no = behind the channel");
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

/// The fields of a table whose columns are looked up by name.
class ForeignTable {
 public:
  ForeignTable(std::unique_ptr<ByteSource> source, std::string_view name)
      : name_(name), lines_(std::move(source), name_) {
    if (!next_line()) {
      throw InputError(name_, 0, 0, "the file is empty", "a table with a line of names");
    }
    const std::string_view header = lines_.line();
    delimiter_ = header.find('\t') != std::string_view::npos  ? '\t'
                 : header.find(';') != std::string_view::npos ? ';'
                                                              : ',';
    read_fields();
    names_ = fields_;
    header_ = {lines_.line_number(), std::string(header)};
  }

  /// @throws InputError where there is none, or two
  std::size_t column(const std::string& name) const {
    const TextPlace line{name_, header_.first, header_.second};
    const auto count = std::count(names_.begin(), names_.end(), name);
    if (count != 1) {
      line.fail(0,
                fmt::format("{} column {}", count == 0 ? "no" : "more than one", in_quotes(name)),
                fmt::format("one of {}", fmt::join(names_, ", ")));
    }
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }

  bool next_row() {
    lines_.next_line(lines_.line_end());
    if (!next_line()) {
      return false;
    }
    read_fields();
    if (fields_.size() != names_.size()) {
      fail(0, fmt::format("{} fields", fields_.size()),
           fmt::format("{}, as in the line of names", names_.size()));
    }
    return true;
  }

  const std::string& text(std::size_t column) const { return fields_[column]; }

  double number(std::size_t column) const {
    const std::string& text = fields_[column];
    const char* position = text.data();
    const char* const end = position + text.size();
    double value = 0;
    if (!parse_number(position, end, value) || position != end || !std::isfinite(value)) {
      fail(column, fmt::format("{} is {}", names_[column], in_quotes(text)),
           "a finite decimal number");
    }
    return value;
  }

  [[noreturn]] void fail(std::size_t column, std::string_view found,
                         std::string_view accepted) const {
    TextPlace{name_, lines_.line_number(), lines_.line()}.fail(
        column < offsets_.size() ? offsets_[column] : 0, found, accepted);
  }

 private:
  bool next_line() {
    while (lines_.fill()) {
      const std::string_view line = lines_.line();
      if (!line.empty() && line.front() != '#') {
        return true;
      }
      lines_.next_line(lines_.line_end());
    }
    return false;
  }

  void read_fields() {
    fields_.clear();
    offsets_.clear();
    CsvLine line(lines_.line(), delimiter_);
    while (line.next()) {
      if (line.broken()) {
        TextPlace{name_, lines_.line_number(), lines_.line()}.fail(
            line.offset(), "a quoted field that does not end with its quote",
            "a field with both quotes, or without");
      }
      fields_.push_back(line.text());
      offsets_.push_back(line.offset());
    }
  }

  std::string name_;
  LineBuffer lines_;
  char delimiter_ = ',';
  std::vector<std::string> fields_;
  std::vector<std::size_t> offsets_;
  std::vector<std::string> names_;
  std::pair<std::uint64_t, std::string> header_;
};

/// Letters, digits and underscores, as the names of sessions and their files are.
std::string session_name(std::string_view text) {
  std::string name(text);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) {
        return !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'));
      },
      '_');
  return name;
}

/// @throws InputError for a rate that its channel cannot hold
void differentiate(std::string_view name, ProfileColumnId id, Channels& channels) {
  const ProfileColumn& channel = profile_columns()[id];
  const NumberRange range{channel.minimum, channel.maximum};
  const std::vector<double>& time_s = channels[kTime];
  const std::vector<double>& values = channels[id];
  std::vector<double> rates(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, values.size() - 1);
    rates[i] = (values[after] - values[before]) / (time_s[after] - time_s[before]);
    if (!range.contains(rates[i])) {
      throw InputError(name, 0, 0,
                       fmt::format("{} becomes {} at {} s", channel.name, rates[i], time_s[i]),
                       range_text(range));
    }
  }
  channels[id] = std::move(rates);
}

}  // namespace

ColumnMap column_map(std::string_view text) {
  return MapReader(text).read();
}

std::string missing_map(const ColumnsOptions& options) {
  const auto has = [&](ProfileColumnId channel) {
    return std::any_of(options.maps.begin(), options.maps.end(),
                       [channel](const ColumnMap& map) { return map.channel == channel; });
  };
  if (has(kTime) == options.rate_Hz.has_value()) {
    return "time_s or a sample rate, one of them";
  }
  if (!has(kInputTensionColumn) && !has(kMotorCurrentColumn)) {
    return "input_tension_N or motor_current_A";
  }
  for (const ProfileColumnId channel : {kOutputTensionColumn, kTendonVelocity}) {
    if (!has(channel)) {
      return std::string(profile_columns()[channel].name);
    }
  }
  for (const ColumnMap& map : options.maps) {
    if (std::count_if(options.maps.begin(), options.maps.end(),
                      [&](const ColumnMap& other) { return other.channel == map.channel; }) > 1) {
      return fmt::format("{} once", profile_columns()[map.channel].name);
    }
  }
  return {};
}

void import_columns(std::unique_ptr<ByteSource> source, std::string_view name,
                    std::string_view session, const ColumnsOptions& options,
                    RecordedCampaign& campaign) {
  ForeignTable table(std::move(source), name);
  std::vector<std::size_t> columns;
  for (const ColumnMap& map : options.maps) {
    columns.push_back(table.column(map.column));
  }
  std::optional<std::size_t> by;
  if (options.session_column) {
    by = table.column(*options.session_column);
  }
  std::map<std::string, Channels> sessions;
  while (table.next_row()) {
    Channels& channels = sessions[session_name(by ? table.text(*by) : session)];
    if (options.rate_Hz) {
      channels[kTime].push_back(static_cast<double>(channels[kTime].size()) / *options.rate_Hz);
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const ColumnMap& map = options.maps[i];
      const ProfileColumn& channel = profile_columns()[map.channel];
      const double value = map.scale * table.number(columns[i]) + map.offset;
      if (!map.rate && !NumberRange{channel.minimum, channel.maximum}.contains(value)) {
        table.fail(columns[i], fmt::format("{} becomes {}", channel.name, value),
                   range_text({channel.minimum, channel.maximum}));
      }
      if (map.channel == kTime && !channels[kTime].empty() && !(value > channels[kTime].back())) {
        table.fail(columns[i],
                   fmt::format("time goes from {} s to {} s", channels[kTime].back(), value),
                   "time that increases within each session");
      }
      channels[map.channel].push_back(value);
    }
  }
  if (sessions.empty()) {
    throw InputError(name, 0, 0, "no rows", "at least one row after the line of names");
  }
  for (auto& [key, channels] : sessions) {
    if (channels[kTime].size() < kFewestSamples) {
      throw InputError(name, 0, 0,
                       fmt::format("{} samples of session {}", channels[kTime].size(), key),
                       fmt::format("at least {}", kFewestSamples));
    }
    for (const ColumnMap& map : options.maps) {
      if (map.rate) {
        differentiate(name, map.channel, channels);
      }
    }
    const auto same = [&key = key](const Recording& recording) { return recording.session == key; };
    if (std::any_of(campaign.recordings.begin(), campaign.recordings.end(), same)) {
      throw InputError(name, 0, 0, fmt::format("session {} a second time", in_quotes(key)),
                       "files or values of a session's column whose letters and digits differ");
    }
    Recording& recording = campaign.recordings.emplace_back();
    recording.session = key;
    recording.specimen = "tendon";
    recording.channels = std::move(channels);
  }
}

std::string unknown_campaign(std::string_view name, bool two_sided) {
  return fmt::format(R"([campaign]
name = "{}"
{}
# Of sheath and drive nothing was known when this was imported. Only the product of friction and angle
# counts; the radius turns the angle of the motor into travel, and the torque constant, ratio and
# efficiency turn a current into a tension.
[model.sheath]
friction_coefficient = 0.1
bend_angle_deg = 180.0

[model.drive]
torque_constant_Nm_per_A = 1.0
gear_ratio = 1.0
gear_efficiency = 1.0
spool_radius_mm = 5.0
current_offset_A = 0.0
)",
                     session_name(name), two_sided ? "two_sided = true\n" : "");
}

}  // namespace host_sim::recording
