#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "host_sim/model/model.hpp"
#include "host_sim/synth/tension/departures.hpp"
#include "host_sim/synth/tension/motion.hpp"
#include "host_sim/synth/tension/sensors.hpp"

namespace host_sim::synth {

/// The two bodies that warm up: each is a first-order process.
struct Thermal {
  double room_C = 20;
  double sheath_time_constant_s = 10;
  double sheath_K_per_W = 0;  ///< by the power that friction turns into heat
  double winding_time_constant_s = 15;
  double winding_K_per_W = 5;
  double winding_resistance_ohm = 1;  ///< at the room's temperature
};

/// Temperature after `step_s` on the way to `end_C`, exact for an end that stands still.
double temperature_after(double now_C, double end_C, double step_s, double time_constant_s);

/// Watts that a current turns into heat: I^2 R, with the resistance of copper at the winding's
/// temperature.
double winding_heat(double current_A, double winding_C, const Thermal& thermal);

using TensionParts = std::span<const std::unique_ptr<TensionPart>>;

/// Tension at the drive's end of the sheath at full slip or less: the capstan equation
/// dT/dphi = mu T z along the angle, solved exactly where mu does not depend on the tension, else
/// by exponential midpoint steps; never below 0.
/// @param mu before the parts
/// @param friction_state z, -1 .. 1
double tension_at_drive_N(TensionParts parts, const Covariates& covariates, double mu,
                          double friction_state);

/// The contact of tendon and sheath, with what it remembers.
class Contact {
 public:
  /// What the contact does in one step: the tendon at the spool moves as `covariates` says, a part
  /// of it stretches the tendon, the rest slides. Sets covariates.slide_m_s.
  /// @return the tension at the drive's end
  double step(TensionParts parts, double mu, Covariates& covariates);

  [[nodiscard]] double friction_state() const { return state_; }

 private:
  double state_ = -1;
  double tension_N_ = 0;
};

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
/// @param instants less than half the time between samples
Channels simulate(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                  TensionParts parts, const Instants& instants = {});

std::size_t samples_of(const Rig& rig);

inline constexpr double kLeastRate_Hz = 4000;

}  // namespace host_sim::synth
