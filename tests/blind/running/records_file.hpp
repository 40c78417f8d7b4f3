#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "tests/blind/records/record.hpp"

namespace blind {

/// Records of a run, a line each. Lines are only added, so that a run can be cut into parts and
/// gone on with; a last line that was cut off is dropped.
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
