#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// The records keep their names even if those of the program change.
std::string_view verdict_name(host_sim::diagnose::Verdict verdict);

/// @throws std::runtime_error
host_sim::diagnose::Verdict verdict_named(const std::string& word);

/// What a campaign hid and what the analysis said about it: all that scores are made of.
struct Record {
  Scenario truth;  ///< without its plan
  std::string truth_sha256;
  std::vector<double> visibility;  ///< of each hidden effect, by oracle; empty where not asked
  double rmse_floor_N = 0;         ///< see rmse_floor_N(); 0 where not asked
  host_sim::diagnose::Findings findings;
  std::string error;  ///< the message where the analysis refused the campaign, else empty
  double seconds = 0;
};

/// One line of JSON without its end; the answer's prose and extensions are left out.
std::string line_of(const Record& record);

/// @throws nlohmann::json::exception, std::runtime_error
Record record_of(const std::string& line);

/// What a record says for a reader: seed, truth, verdict, the first three candidates, seconds.
std::string short_line_of(const Record& record);

/// Ids of what is hidden, in order and joined by "+"; "none" for nothing, "unknown" for what is not
/// of the catalogue. The answer that a perfect analysis gives.
std::string answer_of(const Scenario& truth);

/// Records of a run, a line each. Lines are only added, so that a run can be cut into parts and
/// continued; a last line that was cut off is dropped.
class RecordsFile {
 public:
  /// Reads what is there. @throws OutputError, std::runtime_error with the line that is not right
  explicit RecordsFile(std::filesystem::path path);

  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  [[nodiscard]] bool has(std::uint64_t seed) const;

  /// On disk when it returns.
  void add(Record record);

 private:
  void read();

  std::filesystem::path path_;
  std::vector<Record> records_;
  std::ofstream file_;
};

}  // namespace blind
