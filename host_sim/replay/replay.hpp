#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "hal/files/profile.hpp"
#include "host_sim/extension/acting.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/reference/life.hpp"
#include "host_sim/reference/reference.hpp"
#include "host_sim/replay/given_survival.hpp"
#include "host_sim/replay/virtual_board.hpp"
#include "host_sim/replay/watched.hpp"
#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// How long a wire was seen to live, as a campaign has it.
struct SeenLife {
  double cycles = 0;               ///< full ones and half of the half ones
  double effective_tension_N = 0;  ///< the constant one that does the same damage in as many cycles
  bool failed = false;             ///< else it was whole at the end of the profile
};

/// What one pass of a profile did to the wire, by the estimator and by the reference.
struct ReplayResult {
  hal::files::InputKind input = hal::files::InputKind::kInputTension;
  std::uint64_t samples = 0;
  double duration_s = 0;
  CycleCounts cycles;
  DamageSplit damage;
  DamageSplit reference_damage;
  double relative_error = 0;  ///< damage.total / reference_damage.total - 1
  double equivalent_effective_tension_N = 0;
  double survival_probability = 1;
  reference::LifePoints repeats_to{};           ///< points of the whole life of a new wire
  std::optional<GivenSurvival> given_survival;  ///< where it was asked for
  std::optional<UntilDate> until_date;          ///< the same
  std::vector<std::string> flags;
  std::vector<std::string> warnings;
  std::uint64_t overloads = 0;
  std::uint64_t gaps = 0;
  std::uint64_t missing_samples = 0;  ///< in them
  double peak_tension_N = 0;
  Watched watched;
  std::optional<SeenLife> seen_life;  ///< up to the break; nothing where there was no cycle
  std::string model_digest;
  std::vector<std::string> extensions;      ///< ids of those that were evaluated
  std::vector<NotEvaluated> not_evaluated;  ///< extensions of the model that were not, and why
  std::optional<std::uint64_t> can_frames;  ///< that the firmware sent, where it was asked for
};

/// What a replay writes and shows besides its result.
struct ReplayOptions {
  std::ostream* trajectory = nullptr;
  double trajectory_step_s = 0.1;  ///< at most one row of the trajectory in this time
  ReplayReport* report = nullptr;  ///< its plots are filled
  /// Width of the narrowest classes of cycles in the report, which are as wide or 2, 4, 8 ... times
  /// that; 0 is one by the model.
  double class_N = 0;
  VirtualBoard::Listener can;  ///< hears what the firmware sends; time 0 is the first sample
  protocol::Node node = 1;     ///< of that firmware
  std::optional<AskedOfSurvivor> survivor;
  std::optional<AskedUntil> until;
  std::uint32_t start_cycle = 0;  ///< cycles that the sheath has seen before, for its wear
  std::function<void(std::uint64_t bytes)> progress;
};

/// Feeds a profile sample by sample through the estimator, with the double-precision reference
/// beside it, and where the bus is asked for through the whole firmware. Constant memory, whatever
/// the length of the profile.
/// @param model_name stands for the model in errors
/// @throws InputError for a profile that cannot be trusted or does not go with the model
ReplayResult replay(hal::files::ProfileReader& profile, const Model& model,
                    const std::string& model_name, const ReplayOptions& options);

}  // namespace host_sim
