#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "host_sim/synth/tension/motion.hpp"
#include "host_sim/synth/values.hpp"

namespace host_sim::synth {

/// The sensors whose readings a part may change; that of the velocity only as it is recorded.
enum class Sensor { output_tension, input_tension, motor_current, velocity };

/// One departure of a rig from the nominal model, with its own state in one session. Each function
/// takes a quantity as the parts before it leave it; what a part does not override stays.
class TensionPart {
 public:
  TensionPart() = default;
  TensionPart(const TensionPart&) = delete;
  TensionPart& operator=(const TensionPart&) = delete;
  virtual ~TensionPart() = default;

  /// A session begins; all that is random comes from the seed and the session's number.
  virtual void begin(const Setting& /*setting*/, std::uint64_t /*seed*/) {}

  /// Once an instant, before anything is asked.
  virtual void advance(const Covariates& /*covariates*/) {}

  /// The angle that the tendon really turns by.
  [[nodiscard]] virtual double bend_angle_rad(double angle_rad,
                                              const Covariates& /*covariates*/) const {
    return angle_rad;
  }

  /// Friction coefficient where the tendon carries `tension_N`.
  [[nodiscard]] virtual double friction(double mu, const Covariates& /*covariates*/,
                                        double /*tension_N*/) const {
    return mu;
  }
  /// Whether friction() depends on the tension, so that it changes along the sheath.
  [[nodiscard]] virtual bool along_sheath() const { return false; }

  /// Share of full friction, -1 .. 1, after sliding by `slide_m` from the share `before`.
  [[nodiscard]] virtual double friction_state(double state, double /*before*/,
                                              double /*slide_m*/) const {
    return state;
  }

  /// Tension at the drive's end of the sheath.
  [[nodiscard]] virtual double input_tension_N(double tension_N, double /*friction_state*/,
                                               const Covariates& /*covariates*/) const {
    return tension_N;
  }

  /// Of tendon and sheath in series with the drive.
  [[nodiscard]] virtual double stiffness_N_m() const {
    return std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] virtual double gear_efficiency(double efficiency,
                                               const Covariates& /*covariates*/) const {
    return efficiency;
  }
  /// Torque of the motor, which turns by `rotor_per_travel_rad_m` for each metre of tendon.
  [[nodiscard]] virtual double motor_torque_Nm(double torque_Nm, const Covariates& /*covariates*/,
                                               double /*rotor_per_travel_rad_m*/) const {
    return torque_Nm;
  }
  [[nodiscard]] virtual double torque_constant_Nm_per_A(double constant_Nm_per_A,
                                                        const Covariates& /*covariates*/) const {
    return constant_Nm_per_A;
  }

  /// What a sensor says, in N or A; asked once an instant.
  virtual double reading(Sensor /*sensor*/, double value, const Covariates& /*covariates*/) {
    return value;
  }

  /// What the recorder makes of the readings of a session, one a sample.
  virtual void record(Sensor /*sensor*/, std::vector<double>& /*readings*/,
                      double /*sample_rate_Hz*/) const {}
};

/// A part that a plan may ask for by name.
struct TensionKind {
  std::string_view id;
  std::vector<Parameter> parameters;
  std::vector<Choice> choices;
  std::unique_ptr<TensionPart> (*make)(const Values& values);
};

/// The `make` of a kind whose constructor takes its values.
template <class Part>
std::unique_ptr<TensionPart> make_part(const Values& values) {
  return std::make_unique<Part>(values);
}

/// The effects of the catalogue that a rig may have, in order of its table.
std::span<const TensionKind> tension_kinds();

/// Departures that the catalogue does not have, and those of them that are of sensors.
std::span<const TensionKind> outside_tension_kinds();
std::span<const TensionKind> outside_sensor_kinds();

}  // namespace host_sim::synth
