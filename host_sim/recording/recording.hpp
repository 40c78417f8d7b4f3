#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/profile_columns.hpp"
#include "host_sim/campaign/campaign.hpp"

namespace host_sim::recording {

/// By ProfileColumnId, the values of each channel in the unit of profile_columns(); a channel that
/// was not recorded is empty.
using Channels = std::array<std::vector<double>, hal::files::kProfileColumnCount>;

/// One recording: what the sensors said in one session of a campaign.
struct Recording {
  std::string session;
  std::string specimen;
  std::filesystem::path file;
  double start_cycle = 0;  ///< cycles that the tendon had seen before; at least 0
  std::uint64_t line = 0;  ///< in sessions.csv

  /// Each of samples() values or empty. Time rises strictly.
  Channels channels;
  std::vector<hal::files::NearlyColumn> nearly;  ///< that were passed over

  [[nodiscard]] const std::vector<double>& operator[](hal::files::ProfileColumnId id) const {
    return channels[id];
  }
  [[nodiscard]] bool has(hal::files::ProfileColumnId id) const { return !channels[id].empty(); }
  [[nodiscard]] std::size_t samples() const { return channels[hal::files::kTime].size(); }
};

/// The recordings that sessions.csv of a campaign names, in order of their sessions' names; none
/// where the campaign has no such file. Files are found relative to the folder; `columns` says how
/// those of recordings are taken.
/// @throws InputError for anything that cannot be trusted, and where a recording holds neither
///   input tension nor motor current, or no output tension or no velocity
std::vector<Recording> read_recordings(const std::filesystem::path& campaign_folder,
                                       const hal::files::ColumnOptions& columns = {});

/// Every file that reading a campaign reads, or would where it were there. Of a sessions.csv that
/// cannot be trusted, no recordings.
std::vector<std::filesystem::path> files_of_campaign(const std::filesystem::path& campaign_folder);

/// What a sensor did that no tendon does.
struct Fault {
  enum class Kind {
    constant,     ///< the channel never changes
    dead_load,    ///< nor does the output tension in any session: a weight, or none
    stuck,        ///< it stands still for long while others of its kind move
    saturated,    ///< it stays at its largest or smallest value
    gap,          ///< five samples or more are missing; the sample behind the jump
    passed_over,  ///< it may be there under another name; no samples
  };
  std::string session;
  hal::files::ProfileColumnId channel = hal::files::kTime;
  Kind kind = Kind::constant;
  std::size_t first = 0;  ///< sample at which it begins
  std::size_t count = 0;  ///< samples of the session that it touches
  std::string words;      ///< where, what, and what is done about it
};

/// What is wrong with each channel that the diagnosis reads, in order of session, channel, kind and
/// sample. The rules with their thresholds are in fault_rules.hpp. A temperature or a bend angle
/// may be constant or stand still, and so may an output tension that no session changes, unless it
/// is 0 N against an input that has one sign only. Without a fault a recording may still hold too
/// little: covariates leave out what they cannot use.
std::vector<Fault> faults_of(const std::vector<Recording>& recordings);

/// All faults of one kind in one channel, over all sessions.
struct FaultSummary {
  hal::files::ProfileColumnId channel = hal::files::kTime;
  Fault::Kind kind = Fault::Kind::constant;
  std::size_t sessions = 0;  ///< that have it
  std::size_t faults = 0;
  std::size_t samples = 0;  ///< that they touch
  std::string words;        ///< those of the first fault, and how many more there are
};

/// @param faults of faults_of()
/// @returns by channel, then by kind
std::vector<FaultSummary> summary_of(const std::vector<Fault>& faults);

}  // namespace host_sim::recording
