#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Failure modes, effects and criticality analysis (FMECA): Table 2 of the paper, or one of the
/// user's own.
namespace host_sim::fmeca {

/// A way to fail, by one cause. Ratings are whole, from 1 (harmless, never, always found).
struct FailureMode {
  std::string id;  ///< unique
  std::string component;
  std::string mode;
  std::string cause;
  std::string mechanism;  ///< empty where it has no name
  int severity = 1;
  int occurrence = 1;
  std::optional<int> detection;
  std::vector<std::string> warned_by;  ///< names for what_is(), of what tells before it fails
  std::vector<std::string> seen_by;    ///< of what tells that it has failed
};

/// A name for risks from a number up.
struct RiskLevel {
  std::string name;
  double from = 1;
};

/// A rating of occurrence for rates from one up.
struct OccurrenceRate {
  int rating = 1;
  std::string name;
  double from_per_h = 0;
};

/// The largest ratings.
struct Ratings {
  int severity = 5;
  int occurrence = 5;
  int detection = 5;
};

struct RiskTable {
  std::string file;
  std::string name;
  Ratings largest;
  std::vector<RiskLevel> levels;                 ///< rising, the first from 1; at least one
  std::vector<OccurrenceRate> occurrence_rates;  ///< rising in both, the first from 0; may be empty
  std::vector<FailureMode> modes;                ///< at least one
};

/// @throws InputError with file, line and column for anything unknown, missing, of the wrong type
/// or out of range, and for names of what watches that there are not
[[nodiscard]] RiskTable parse_table(std::string_view text, std::string_view file);
[[nodiscard]] RiskTable read_table(const std::filesystem::path& path);

/// Table 2 of the paper.
[[nodiscard]] RiskTable paper_table();

/// What a name of something that watches means: of a frame or a page on the bus (`Timing`), a
/// signal of one (`LifeStatus.Slack`), a value of such a signal (`LifeStatus.LifeState.worn`), or
/// `effect.ID` of the catalogue of diagnose.
struct Watch {
  std::string words;     ///< empty where the name means nothing
  std::string accepted;  ///< then what could stand in its place
};

[[nodiscard]] Watch what_is(std::string_view name);

}  // namespace host_sim::fmeca
