#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/profile_columns.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/synth/life_departures.hpp"
#include "host_sim/synth/tension/motion.hpp"
#include "host_sim/synth/tension/rig.hpp"
#include "host_sim/synth/tension/sensors.hpp"
#include "host_sim/synth/values.hpp"

namespace host_sim::synth {

/// [recordings]: what sessions are run at, each list with at least one value.
struct RecordingPlan {
  enum class Design {
    crossed,   ///< each value of each list with each of the others
    listed,    ///< the first of all lists, the second of all lists, ...; one value stays
    balanced,  ///< `sessions`, with the values of each list equally often, shuffled on their own
  };
  Design design = Design::crossed;
  std::size_t sessions = 0;  ///< balanced only
  std::size_t repeats = 1;
  std::vector<double> bend_angles_deg, output_means_N, output_amplitudes_N, frequencies_Hz,
      travels_mm, sheath_ambients_C, winding_starts_C, start_cycles;
  double sample_rate_Hz = 200;
  double duration_s = 20;
  Motion motion;
  std::vector<hal::files::ProfileColumnId> channels;  ///< of the files, time first
};

/// [scatter]: what differs from session to session and is no effect.
struct ScatterPlan {
  double log_gain_sd = 0;
  double friction_sd = 0;  ///< absolute, of mu
};

/// [[lives.level]]: specimens at one constant load.
struct LifeLevel {
  LifeLoad load;
  std::size_t specimens = 0;
  double suspend_at_cycles = 1e15;
  double inspect_every_cycles = 0;  ///< 0: lives are known to the cycle
  /// So many of the lowest and of the highest lives are dropped.
  std::size_t trim_low = 0, trim_high = 0;
  bool validation = false;
};

/// [[lives.program]]: specimens that go from one level to the next; the last one has no end but
/// its suspension.
struct LifeProgram {
  std::vector<std::size_t> levels;  ///< places in LifePlan::levels, at least two
  std::vector<double> cycles;       ///< of all steps but the last
  std::size_t specimens = 0;
  bool validation = false;
};

/// [lives]
struct LifePlan {
  enum class LotsBy {
    specimen,  ///< dealt to the specimens in turn: crossed with the levels
    level,     ///< each level has specimens of one lot
  };
  std::size_t lots = 1;
  LotsBy lots_by = LotsBy::specimen;
  std::size_t rigs = 1;
  std::vector<double> storage_days;  ///< in turn
  bool record_days = false;
  std::vector<LifeLevel> levels;
  std::vector<LifeProgram> programs;

  [[nodiscard]] std::size_t specimens() const;
};

/// A departure from the nominal model that is to be hidden.
struct Departure {
  std::string id;
  bool outside = false;  ///< of [outside], not of the catalogue
  bool of_life = false;
  Values values;
};

/// What a campaign is made of.
struct SynthPlan {
  std::string file;  ///< what stands for the plan in errors
  std::string name;
  bool two_sided = false;  ///< forces of either sign; the effects of two_sided_kinds()
  NominalModel model;
  Thermal thermal;
  std::optional<RecordingPlan> recordings;
  Noise noise;
  ScatterPlan scatter;
  std::optional<LifePlan> lives;
  std::vector<Departure> departures;  ///< in order of the catalogue
};

/// Reads and checks a plan; `name` stands for the file in errors.
/// @throws InputError with the place of what is unknown, missing, of the wrong type, out of range,
///   or at odds with the rest
SynthPlan parse_synth_plan(std::string_view text, std::string_view name);

/// The same for a file, `-` for standard input.
SynthPlan read_synth_plan(const std::filesystem::path& path);

/// The sessions of a plan in the order in which they are run. A crossed design runs through the
/// last of its lists first; repeats follow each other as a whole. Only a balanced one depends on
/// the seed.
std::vector<Setting> settings_of(const RecordingPlan& plan, std::uint64_t seed);

/// How many they are; for a crossed design at most kMostSessions + 1.
std::size_t session_count(const RecordingPlan& plan);

inline constexpr std::size_t kMostSessions = 10'000;

}  // namespace host_sim::synth
