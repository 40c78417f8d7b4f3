#include "host_sim/io/profile_header.hpp"

#include <fmt/format.h>

#include <array>
#include <bitset>
#include <string>

#include "host_sim/io/csv_line.hpp"
#include "host_sim/io/unit_suffix.hpp"

namespace host_sim {
namespace {

using Present = std::bitset<kProfileColumnCount>;

constexpr std::array<InputKind, 3> kKinds{InputKind::kInputTension, InputKind::kMotorCurrent,
                                          InputKind::kOutputTension};
constexpr std::string_view kNeeded =
    "time_s and one of input_tension_N, motor_current_A, output_tension_N with "
    "tendon_velocity_m_s";

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

ProfileColumnId tension_column(InputKind kind) {
  switch (kind) {
    case InputKind::kInputTension:
      return kInputTensionColumn;
    case InputKind::kMotorCurrent:
      return kMotorCurrentColumn;
    case InputKind::kOutputTension:
      return kOutputTensionColumn;
  }
  return kProfileColumnCount;
}

bool holds(const Present& present, InputKind kind) {
  return present[tension_column(kind)] &&
         (kind != InputKind::kOutputTension || present[kTendonVelocity]);
}

[[noreturn]] void fail_missing(const TextPlace& line, std::string_view column,
                               std::string_view needed = kNeeded) {
  line.fail(line.text.size(), fmt::format("no column {}", column), needed);
}

InputKind chosen_kind(const Present& present, const TextPlace& line,
                      const ProfileOptions& options) {
  for (const InputKind kind : kKinds) {
    if (options.input.value_or(kind) == kind && holds(present, kind)) {
      return kind;
    }
  }
  if (options.input && !present[tension_column(*options.input)]) {
    fail_missing(line, name_of(tension_column(*options.input)));
  }
  if (present[kOutputTensionColumn]) {
    fail_missing(line, name_of(kTendonVelocity));
  }
  fail_missing(line, "of tension or current");
}

}  // namespace

std::vector<ProfileColumnId> parse_profile_columns(const TextPlace& line, std::string_view needed) {
  if (line.text.empty()) {
    line.fail(0, "an empty line in place of the header", needed);
  }
  std::vector<ProfileColumnId> columns;
  Present present;
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

ProfileHeader parse_profile_header(const TextPlace& line, const ProfileOptions& options) {
  ProfileHeader header{};
  header.columns = parse_profile_columns(line, kNeeded);
  Present present;
  for (const ProfileColumnId id : header.columns) {
    present.set(id);
  }
  header.kind = chosen_kind(present, line, options);
  header.has_bend_angle = header.kind == InputKind::kOutputTension && present[kBendAngle];
  return header;
}

}  // namespace host_sim
