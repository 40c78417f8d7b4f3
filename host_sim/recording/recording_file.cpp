#include "host_sim/recording/recording_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host_sim/io/input_error.hpp"
#include "host_sim/io/interruption.hpp"
#include "host_sim/io/profile_header.hpp"
#include "host_sim/io/profile_rows.hpp"

namespace host_sim::recording {
namespace {

constexpr std::string_view kNeeded =
    "time_s, output_tension_N, tendon_velocity_m_s, and input_tension_N or motor_current_A or both";

std::vector<ProfileColumnId> columns_in(const TextPlace& line) {
  std::vector<ProfileColumnId> columns = parse_profile_columns(line, kNeeded);
  const auto has = [&](ProfileColumnId id) {
    return std::find(columns.begin(), columns.end(), id) != columns.end();
  };
  const auto fail = [&](std::string_view missing) {
    line.fail(line.text.size(), fmt::format("no column {}", missing), kNeeded);
  };
  if (!has(kInputTensionColumn) && !has(kMotorCurrentColumn)) {
    fail("input_tension_N or motor_current_A");
  }
  for (const ProfileColumnId id : {kOutputTensionColumn, kTendonVelocity}) {
    if (!has(id)) {
      fail(profile_columns()[id].name);
    }
  }
  return columns;
}

}  // namespace

Channels parse_recording(std::unique_ptr<ByteSource> source, std::string_view name) {
  constexpr std::size_t kSamplesBetweenStops = 1 << 16;
  ProfileRows rows(std::move(source), name, fmt::format("a CSV file with {}", kNeeded), columns_in);
  Channels channels;
  while (rows.next()) {
    for (const ProfileColumnId id : rows.columns()) {
      channels[id].push_back(rows.values()[id]);
    }
    if (channels[kTime].size() % kSamplesBetweenStops == 0) {
      stop_if_interrupted();
    }
  }
  const std::size_t samples = channels[kTime].size();
  if (samples < kFewestSamples) {
    throw InputError(name, rows.lines().line_number(), 0,
                     fmt::format("the file ends after {} samples", samples),
                     fmt::format("at least {} samples", kFewestSamples));
  }
  return channels;
}

}  // namespace host_sim::recording
