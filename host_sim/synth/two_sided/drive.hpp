#pragma once

#include <limits>

#include "host_sim/synth/tension/rig.hpp"

namespace host_sim::synth {

/// What a drive that works in both directions hides; as it stands, nothing.
struct TwoSidedEffects {
  double preload_N = 0;      ///< friction whatever the load, against the motion
  double viscous_N_s_m = 0;  ///< friction in proportion to the velocity
  double presliding_m = 0;   ///< travel over which friction turns over
  double load_exponent = 0;  ///< k of mu (|T| / reference)^-k
  double load_reference_N = 1;
  double bump = 0;  ///< share by which all friction is larger about a place of the stroke
  double bump_centre_m = 0;
  double bump_width_m = 1;
  double play_m = 0;  ///< through which the drive moves and the tendon does not
  double stiffness_N_m = std::numeric_limits<double>::infinity();
  double output_zero_N = 0;
  double output_lag_s = 0;
  double input_lag_s = 0;
  double output_delay_s = 0;
  double input_delay_s = 0;
  double one_way = 0;   ///< share by which friction is larger while pulling; outside
  double moved_kg = 0;  ///< mass that the drive speeds up; outside
  double creep = 0;     ///< share by which the force at the drive drifts; outside
  double creep_time_s = 1;
};

/// The contact of tendon and sheath of a drive that works in both directions, as a slider on a
/// spring: friction lies between that of sliding one way and that of sliding the other way.
class TwoSidedContact {
 public:
  /// @param friction_coefficient mu of the sheath
  TwoSidedContact(double friction_coefficient, const TwoSidedEffects& effects)
      : mu_(friction_coefficient), effects_(effects) {}

  /// Goes on to the instant of `covariates`. @return the force at the drive
  double step(const Covariates& covariates);

 private:
  [[nodiscard]] double slip_after(double slide_m) const;
  [[nodiscard]] double sliding_N(const Covariates& covariates, double slip, double slide_m) const;
  double stretched_N(const Covariates& covariates, double travel_m);

  double mu_;
  const TwoSidedEffects& effects_;
  double slip_ = -1;    ///< share of full friction, -1 .. 1
  double taken_m_ = 0;  ///< of the play
  double force_N_ = 0;
  bool begun_ = false;
};

/// One session of such a drive: what sensors without noise say. There are no temperatures.
Channels simulate_two_sided(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                            const TwoSidedEffects& effects, const Instants& instants = {});

}  // namespace host_sim::synth
