#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/verbs/outputs.hpp"

namespace host_sim {

/// The command line of `calibrate`.
struct CalibrateArguments {
  std::string folder;
  std::string out;
  std::string json;
  std::string report;
  std::string table;
  bool batch = false;
  std::uint64_t seed = 1;
  std::size_t bootstraps = 10'000;
  unsigned threads = 0;
  std::vector<double> use_tensions_N;
  bool keep_all_levels = false;
  std::vector<std::string> fail_on;

  [[nodiscard]] std::array<std::string, 4> outputs() const { return {out, json, report, table}; }
  /// @param campaigns that are read
  [[nodiscard]] VerbFiles files(std::span<const std::string> campaigns) const;
  [[nodiscard]] calibrate::CalibrateOptions options() const;
};

/// One campaign. @return the exit status @throws InputError, OutputError, Interruption
int calibrate_one(const CalibrateArguments& arguments);

/// All campaigns of a folder, by all ranks. The same.
int calibrate_batch(const CalibrateArguments& arguments);

}  // namespace host_sim
