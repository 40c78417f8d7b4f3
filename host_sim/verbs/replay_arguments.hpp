#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware/protocol/messages.hpp"
#include "hal/files/column_map.hpp"
#include "host_sim/verbs/outputs.hpp"

namespace host_sim {

/// The command line of `replay`.
struct ReplayArguments {
  std::vector<std::string> profiles;
  std::string model;
  std::string input;
  hal::files::ColumnOptions columns;
  std::string json;
  std::string table;
  unsigned threads = 0;
  std::string trajectory;
  double trajectory_step_s = 0.1;
  std::string report;
  std::string can;
  std::string specimens;
  protocol::Node node = 1;
  std::optional<std::uint32_t> start_cycle;
  std::optional<double> used;
  std::string horizon;
  std::string until_date;
  std::string today;
  double hours_per_day = 24;
  double risk = 0.1;
  std::vector<std::string> fail_on;

  [[nodiscard]] std::array<std::string, 6> outputs() const {
    return {json, table, trajectory, report, can, specimens};
  }
  /// Without the profiles.
  [[nodiscard]] VerbFiles files() const {
    return {.reads = {{"--model", model}},
            .writes = {{"--json", json},
                       {"--table", table},
                       {"--trajectory", trajectory},
                       {"--report", report},
                       {"--can", can},
                       {"--specimens", specimens}},
            .fills = {}};
  }
};

/// All profiles, by all ranks. @return the exit status @throws InputError, OutputError,
/// Interruption
int replay_many(const ReplayArguments& arguments);

}  // namespace host_sim
