#pragma once

#include <cstdint>
#include <optional>

#include "host_sim/io/model.hpp"
#include "host_sim/synth/tension/channels.hpp"
#include "host_sim/synth/tension/motion.hpp"
#include "host_sim/synth/tension/sheath.hpp"
#include "host_sim/synth/tension/thermal.hpp"

namespace host_sim::synth {

/// What is the same in all sessions.
struct Rig {
  double friction_coefficient = 0;  ///< mu of the nominal model
  std::optional<Model::Drive> drive;
  Motion motion;
  Thermal thermal;
  double sample_rate_Hz = 200;
  double duration_s = 20;
};

/// What is drawn for one session: scatter that is no effect.
struct SessionScatter {
  double log_gain = 0;  ///< of the output load cell
  double friction = 0;  ///< added to mu
};

/// One session, integrated in time at kLeastRate_Hz or faster: what sensors without noise say, each
/// sample_rate_Hz. Motor current is there only with a drive.
/// @param parts of this session alone, whose begin() has been called
Channels simulate(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                  Parts parts);

inline constexpr double kLeastRate_Hz = 4000;

}  // namespace host_sim::synth
