#include "host_sim/recording/import_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>

#include "hal/files/csv.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/nearest.hpp"
#include "hal/files/profile_columns.hpp"
#include "hal/files/text.hpp"
#include "host_sim/recording/recording_files.hpp"

namespace host_sim::recording {

using hal::files::ByteSource;
using hal::files::column_word;
using hal::files::ColumnMap;
using hal::files::CsvLine;
using hal::files::in_quotes;
using hal::files::InputError;
using enum hal::files::ProfileColumnId;
using hal::files::LineBuffer;
using hal::files::nearest;
using hal::files::NumberRange;
using hal::files::profile_columns;
using hal::files::ProfileColumn;
using hal::files::ProfileColumnId;
using hal::files::range_text;
using hal::files::TextPlace;

namespace {

/// The fields of a table whose columns are looked up by name.
class ForeignTable {
 public:
  ForeignTable(std::unique_ptr<ByteSource> source, std::string_view name)
      : name_(name), lines_(std::move(source), name_) {
    if (!next_line()) {
      throw InputError(name_, 0, 0, "the file is empty", "a table with a line of names");
    }
    const std::string_view header = lines_.line();
    dialect_ = hal::files::dialect_of(header);
    read_fields();
    names_ = fields_;
    header_ = {lines_.line_number(), std::string(header)};
    const auto is_number = [](const std::string& field) {
      return hal::files::finite_number(field).has_value();
    };
    if (std::ranges::all_of(names_, is_number)) {
      fail_header("numbers in the first line", "a line with the names of the columns before it");
    }
  }

  /// @throws InputError where there is none, or two
  std::size_t column(const std::string& name) const {
    const auto count = std::count(names_.begin(), names_.end(), name);
    if (count != 1) {
      const auto meant = count == 0 ? nearest(name, names_) : std::nullopt;
      fail_header(fmt::format("{} column {}", count == 0 ? "no" : "more than one", in_quotes(name)),
                  meant ? column_word(*meant) : fmt::format("one of {}", fmt::join(names_, ", ")));
    }
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }

  bool has(std::string_view name) const { return std::ranges::find(names_, name) != names_.end(); }

  [[noreturn]] void fail_header(std::string_view found, std::string_view accepted) const {
    TextPlace{name_, header_.first, header_.second}.fail(0, found, accepted);
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

  /// As logs have it where a sensor gave nothing.
  bool is_missing(std::size_t column) const {
    constexpr std::string_view kNothing[] = {"", "nan", "na", "n/a", "null", "none"};
    std::string text = fields_[column];
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::ranges::find(kNothing, text) != std::end(kNothing);
  }

  double number(std::size_t column) const {
    const auto value = hal::files::finite_number(fields_[column]);
    if (!value) {
      const auto none = hal::files::no_number(fields_[column], dialect_);
      fail(column, fmt::format("{} is {}", names_[column], none.found),
           none.accepted +
               (is_missing(column) ? ", or --ignore-missing to pass such rows over" : ""));
    }
    return *value;
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
    CsvLine line(lines_.line(), dialect_);
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
  hal::files::CsvDialect dialect_;
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

/// The maps of the options, and a column that has a channel's own name where none makes it.
/// @throws InputError where a recording lacks a channel that it needs
std::vector<ColumnMap> maps_of(const ColumnsOptions& options, const ForeignTable& table) {
  std::vector<ColumnMap> maps = options.maps;
  const auto has = [&](ProfileColumnId channel) {
    return std::ranges::find(maps, channel, &ColumnMap::channel) != maps.end();
  };
  for (unsigned id = options.rate_Hz ? kTime + 1 : kTime; id < kProfileColumnCount; ++id) {
    const auto channel = static_cast<ProfileColumnId>(id);
    const bool written = channel == kOutputTensionColumn && options.dead_load_N;
    if (!has(channel) && !written && table.has(profile_columns()[id].name)) {
      maps.push_back({.channel = channel, .column = std::string(profile_columns()[id].name)});
    }
  }
  const auto fail = [&](std::string_view channel, std::string_view other) {
    table.fail_header(fmt::format("no column for {}", channel),
                      fmt::format("--column COLUMN={}{}", channel, other));
  };
  if (!options.rate_Hz && !has(kTime)) {
    fail("time_s", ", or --sample-rate-Hz");
  }
  if (!has(kInputTensionColumn) && !has(kMotorCurrentColumn)) {
    fail("input_tension_N", ", or motor_current_A");
  }
  if (!options.dead_load_N && !has(kOutputTensionColumn)) {
    fail("output_tension_N", ", or --dead-load-N");
  }
  if (!has(kTendonVelocity)) {
    fail("tendon_velocity_m_s",
         ", or of a position in m --column 'rate(COLUMN)=tendon_velocity_m_s'");
  }
  return maps;
}

}  // namespace

std::string conflict_of(const ColumnsOptions& options) {
  for (auto map = options.maps.begin(); map != options.maps.end(); ++map) {
    if (std::find_if(options.maps.begin(), map, [&](const ColumnMap& before) {
          return before.channel == map->channel;
        }) != map) {
      return fmt::format("{} once", profile_columns()[map->channel].name);
    }
    if (map->channel == kTime && options.rate_Hz) {
      return "time_s or a sample rate, one of them";
    }
    if (map->channel == kOutputTensionColumn && options.dead_load_N) {
      return "output_tension_N or a dead load, one of them";
    }
  }
  return {};
}

void import_columns(std::unique_ptr<ByteSource> source, std::string_view name,
                    std::string_view session, const ColumnsOptions& options,
                    RecordedCampaign& campaign) {
  ForeignTable table(std::move(source), name);
  const std::vector<ColumnMap> maps = maps_of(options, table);
  std::vector<std::size_t> columns;
  columns.reserve(maps.size());
  for (const ColumnMap& map : maps) {
    columns.push_back(table.column(map.column));
  }
  std::optional<std::size_t> by;
  if (options.session_column) {
    by = table.column(*options.session_column);
  }
  std::map<std::string, Channels> sessions;
  std::map<std::string, std::size_t> rows;
  while (table.next_row()) {
    const std::string of = session_name(by ? table.text(*by) : session);
    const std::size_t row = rows[of]++;
    if (options.ignore_missing && std::ranges::any_of(columns, [&](std::size_t column) {
          return table.is_missing(column);
        })) {
      ++campaign.passed_over;
      continue;
    }
    Channels& channels = sessions[of];
    if (options.rate_Hz) {
      channels[kTime].push_back(static_cast<double>(row) / *options.rate_Hz);
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const ColumnMap& map = maps[i];
      const ProfileColumn& channel = profile_columns()[map.channel];
      const double value = map.of(table.number(columns[i]));
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
    if (options.dead_load_N) {
      channels[kOutputTensionColumn].assign(channels[kTime].size(), *options.dead_load_N);
    }
    for (const ColumnMap& map : maps) {
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
