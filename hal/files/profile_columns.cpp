#include "hal/files/profile_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

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

}  // namespace hal::files
