#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "host_sim/model/model.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/watch/wire_watch.hpp"

namespace host_sim {

/// What a wire can be found in.
enum class WireEvent : std::uint8_t { slack, broken };

/// `slack` or `broken`.
std::string_view to_string(WireEvent event);

/// The first sample that shows it.
struct FoundInWire {
  WireEvent event = WireEvent::slack;
  double time_s = 0;       ///< as in the profile
  std::uint64_t line = 0;  ///< of the profile
};

/// What was watched of a wire besides its cycles, by the watch that a board runs.
struct Watched {
  Model::Watch limits{};
  bool suggested = false;  ///< the limits are not of the model but of suggested_watch()
  bool motion = false;     ///< the profile tells the motion; without it neither slack nor break
  double peak_ratio = 0;   ///< highest tension by its size, T/T_u
  std::array<std::uint32_t, lifemodel::WatchReading::kLevels> above{};  ///< 50, 70, 90 %
  double below_minimum_s = 0;
  std::uint32_t slack_events = 0;
  bool broken = false;
  std::vector<FoundInWire> found;  ///< the first kMostFound

  static constexpr std::size_t kMostFound = 1000;
};

/// Limits for a model that has none, from what it says of its wire:
///   broken tension  what the sheath makes without load, friction_preload, and the hysteresis, the
///                   smallest range that the model takes for more than noise
///   minimum         twice that
///   slack travel    the play of the wire in its sheath, at a clearance of one diameter the
///   diameter
///                   times the bend angle; at least 1 mm
///   broken travel   ten times that: more slack than play and stretch leave to be taken up
/// None where these tensions are not below the ultimate one.
Model::Watch suggested_watch(const Model& model);

/// The watch of a board over the samples of a profile.
class WireFollower {
 public:
  /// Without `[watch]` in the model the limits are suggested ones.
  WireFollower(const Model& model, const lifemodel::Parameters& parameters, bool motion);

  void take(double time_s, std::uint64_t line, lifemodel::Tension tension,
            lifemodel::Velocity velocity);
  void miss(std::uint32_t samples) { watch_.miss(samples); }
  /// The first sample that found the wire broken was the last one.
  [[nodiscard]] bool just_broken() const { return just_broken_; }

  [[nodiscard]] Watched result() const;

 private:
  void note(double time_s, std::uint64_t line);

  Watched watched_;
  lifemodel::WireWatch watch_;
  double period_s_;
  lifemodel::WatchReading before_;  ///< when something was found last
  bool just_broken_ = false;
};

}  // namespace host_sim
