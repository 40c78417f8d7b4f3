#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_file.hpp"
#include "host_sim/fmeca/table.hpp"

namespace host_sim::fmeca {

/// Events of one failure mode counted in the field.
struct FieldCount {
  std::uint64_t events = 0;
  double operating_h = 0;

  /// The rate that it lies below with 60 % confidence (chi-square with 2 events + 2 degrees of
  /// freedom): few hours without an event prove little.
  [[nodiscard]] double limit_per_h() const;
};

/// By the id of the failure mode.
using FieldCounts = std::map<std::string, FieldCount>;

/// Reads CSV with `failure` (an id of the table), `events` (whole, 0 or more) and `operating_hours`
/// (above 0); rows of one failure add up.
/// @throws InputError, also where the table has no rates to rate them by
[[nodiscard]] FieldCounts parse_field(std::unique_ptr<hal::files::ByteSource> source,
                                      std::string_view name, const RiskTable& table);
[[nodiscard]] FieldCounts read_field(const std::filesystem::path& path, const RiskTable& table);

/// What is said of one failure mode.
struct Assessed {
  const FailureMode* mode = nullptr;
  int occurrence = 1;               ///< of the field where it was counted there, else of the table
  std::optional<FieldCount> field;  ///< none where it was not counted
  int risk = 1;                     ///< severity * occurrence
  std::optional<int> rpn;           ///< times detection: the risk priority number
  std::size_t level = 0;            ///< of the risk, in the levels of the table
  std::size_t rank = 1;  ///< by risk priority number, or without by risk; equals share one
};

/// Largest first; at one rank the graver first, then as in the table.
struct Assessment {
  const RiskTable* table = nullptr;
  std::vector<Assessed> modes;

  [[nodiscard]] bool has_rpn() const { return modes.front().rpn.has_value(); }
};

/// @pre the table outlives the assessment
[[nodiscard]] Assessment assess(const RiskTable& table, const FieldCounts& field);

[[nodiscard]] std::string fmeca_json(const Assessment& assessment);

/// CSV with a row for each failure mode.
[[nodiscard]] std::string fmeca_table(const Assessment& assessment);

/// For people.
void write_fmeca(std::ostream& out, const Assessment& assessment);

/// What there is and what nothing watches, in a sentence.
[[nodiscard]] std::string sentence_of(const Assessment& assessment);

}  // namespace host_sim::fmeca
