#include "hal/files/profile_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "hal/files/nearest.hpp"
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

std::vector<std::string> names_of(const std::vector<ProfileField>& fields) {
  std::vector<std::string> names;
  std::ranges::transform(fields, std::back_inserter(names), &ProfileField::name);
  return names;
}

/// A word of a command line, as a shell takes it where it is printable.
std::string option_word(const std::string& map) {
  return map.find_first_of(" \"*()[];&|<>$`\\") == std::string::npos ? map : '\'' + map + '\'';
}

std::vector<std::string> known_names() {
  std::vector<std::string> known;
  std::ranges::transform(kColumns, std::back_inserter(known),
                         [](const ProfileColumn& column) { return std::string(column.name); });
  return known;
}

/// A column in another unit than ours, or without one.
struct InOtherUnit {
  ProfileColumnId id;
  std::string unit;
  bool unit_is_known;
  std::string map;  ///< of --column; its factor is to be filled in where the unit is not known
};

std::optional<InOtherUnit> in_other_unit(const std::string& name) {
  for (unsigned index = 0; index < kProfileColumnCount; ++index) {
    const ProfileColumn& column = kColumns[index];
    const auto unit = other_unit(name, column.name, column.unit);
    if (!unit) {
      continue;
    }
    const auto id = static_cast<ProfileColumnId>(index);
    const std::string plain = fmt::format("{}={}", column_word(name), column.name);
    if (unit->empty()) {
      return InOtherUnit{id, "", true, plain};
    }
    const auto map = map_of_unit(name, *unit, id);
    return InOtherUnit{id, std::string(*unit), map.has_value(), map.value_or("FACTOR*" + plain)};
  }
  return std::nullopt;
}

/// The names of a header, and what each of them is.
class ProfileHeaderReader {
 public:
  ProfileHeaderReader(const TextPlace& line, std::string_view needed, const ColumnOptions& options)
      : line_(line), needed_(needed), options_(options) {}

  ProfileLayout read() {
    if (line_.text.empty()) {
      line_.fail(0, "an empty line in place of the header", needed_);
    }
    layout_.dialect = dialect_of(line_.text);
    read_names();
    std::ranges::for_each(options_.maps, [this](const ColumnMap& map) { take_map(map); });
    for (std::size_t field = 0; field < layout_.fields.size(); ++field) {
      if (layout_.fields[field].passed_over()) {
        take_name(field);
      }
    }
    if (!layout_.channels[kTime]) {
      line_.fail(line_.text.size(), fmt::format("no column {}", name_of(kTime)), needed_);
    }
    std::ranges::for_each(layout_.fields, [this](const ProfileField& field) { doubt(field); });
    return std::move(layout_);
  }

 private:
  void read_names() {
    CsvLine names(line_.text, layout_.dialect);
    while (names.next()) {
      if (names.broken()) {
        line_.fail(names.offset(), "a quoted name that does not end with its quote",
                   profile_column_names());
      }
      layout_.fields.push_back({.name = names.text()});
      offsets_.push_back(names.offset());
    }
  }

  void take_map(const ColumnMap& map) {
    const auto found = std::ranges::find(layout_.fields, map.column, &ProfileField::name);
    if (found == layout_.fields.end()) {
      const std::vector<std::string> names = names_of(layout_.fields);
      const auto meant = nearest(map.column, names);
      line_.fail(0, fmt::format("no column {} for {}", in_quotes(map.column), name_of(map.channel)),
                 meant ? column_word(*meant) : fmt::format("one of {}", fmt::join(names, ", ")));
    }
    found->id = map.channel;
    found->scale = map.scale;
    found->offset = map.offset;
    layout_.channels.set(map.channel);
  }

  void take_name(std::size_t index) {
    ProfileField& field = layout_.fields[index];
    const auto known = std::ranges::find(kColumns, field.name, &ProfileColumn::name);
    if (known == kColumns.end()) {
      if (!options_.ignore_extra) {
        refuse_unknown(index);
      }
      return;
    }
    const auto id = static_cast<ProfileColumnId>(known - kColumns.begin());
    if (layout_.channels[id]) {
      if (!options_.ignore_extra ||
          std::ranges::find(options_.maps, id, &ColumnMap::channel) == options_.maps.end()) {
        line_.fail(offsets_[index], fmt::format("column {} a second time", name_of(id)),
                   "each column once");
      }
      return;
    }
    field.id = id;
    layout_.channels.set(id);
  }

  /// @param map of --column, empty where none is known
  std::string accepted(std::string_view what, const std::string& map) const {
    if (!options_.given_by_options) {
      return std::string(what);
    }
    return fmt::format("{}; --column {}, or --ignore-extra to pass it over", what,
                       option_word(map));
  }

  [[noreturn]] void refuse_unknown(std::size_t index) const {
    const std::string& name = layout_.fields[index].name;
    if (name.starts_with("Unnamed: ") || (name.empty() && index == 0)) {
      line_.fail(offsets_[index],
                 fmt::format("column {}, as pandas writes the index of its rows", in_quotes(name)),
                 options_.given_by_options ? "--ignore-extra, or to_csv(index=False) in pandas"
                                           : "to_csv(index=False) in pandas");
    }
    refuse_other_unit(index);
    const auto meant = nearest(name, known_names());
    line_.fail(offsets_[index],
               fmt::format("unknown column {}{}", in_quotes(name),
                           meant ? fmt::format(", nearest to {}", *meant) : ""),
               accepted(profile_column_names(),
                        fmt::format("{}={}", column_word(name), meant.value_or("COLUMN"))));
  }

  void refuse_other_unit(std::size_t index) const {
    const std::string& name = layout_.fields[index].name;
    const auto found = in_other_unit(name);
    if (!found) {
      return;
    }
    const std::string_view known = kColumns[found->id].name;
    if (found->unit.empty()) {
      line_.fail(offsets_[index], fmt::format("column {} without its unit", in_quotes(name)),
                 accepted(known, found->map));
    }
    line_.fail(offsets_[index],
               fmt::format("{} unit {} of column {}", found->unit_is_known ? "other" : "unknown",
                           in_quotes(found->unit), in_quotes(name)),
               accepted(known, found->map));
  }

  /// Who passes over all that is extra may not mean what is nearly one of ours.
  void doubt(const ProfileField& field) {
    if (!field.passed_over()) {
      return;
    }
    auto id = kProfileColumnCount;
    std::string map;
    if (const auto found = in_other_unit(field.name)) {
      id = found->id;
      map = found->map;
    } else if (const auto meant = nearest(field.name, known_names())) {
      id = static_cast<ProfileColumnId>(std::ranges::find(kColumns, *meant, &ProfileColumn::name) -
                                        kColumns.begin());
      map = fmt::format("{}={}", column_word(field.name), *meant);
    }
    if (id != kProfileColumnCount && !layout_.channels[id]) {
      layout_.nearly.push_back(
          {id, fmt::format("column {} is passed over, which is nearly {}; --column {} takes it",
                           in_quotes(field.name), name_of(id), option_word(map))});
    }
  }

  const TextPlace& line_;
  std::string_view needed_;
  const ColumnOptions& options_;
  ProfileLayout layout_;
  std::vector<std::size_t> offsets_;
};

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

ProfileLayout parse_profile_columns(const TextPlace& line, std::string_view needed,
                                    const ColumnOptions& options) {
  return ProfileHeaderReader(line, needed, options).read();
}

}  // namespace hal::files
