#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace host_sim::synth {

/// What one session is run at.
struct Setting {
  std::size_t number = 0;  ///< from 0, in the order in which the sessions are run
  std::size_t pose = 0;    ///< place of the bend angle among those of the plan
  double bend_angle_deg = 0;
  double output_mean_N = 0;
  double output_amplitude_N = 0;
  double frequency_Hz = 0;
  double travel_mm = 0;  ///< peak to peak
  double sheath_ambient_C = 0;
  double winding_start_C = 0;
  double start_cycle = 0;
};

/// The state of the rig at one instant of a session.
struct Covariates {
  double time_s = 0;
  double step_s = 0;        ///< since the instant before; 0 for the first
  double wall_clock_h = 0;  ///< since the first session began
  double cycle = 0;         ///< start cycle plus those run since
  double position_m = 0;    ///< of the tendon at the spool, positive when pulled in
  double travel_m = 0;      ///< signed, since the instant before
  double velocity_m_s = 0;  ///< at the spool
  double acceleration_m_s2 = 0;
  double direction = 1;  ///< sign of the velocity; at zero the one before
  double slide_m_s = 0;  ///< velocity of the tendon in the sheath
  double bend_angle_rad = 0;
  double bend_rate_rad_s = 0;
  double output_tension_N = 0;
  double ambient_C = 0;
  double sheath_C = 0;
  double winding_C = 0;
};

/// How the tendon is moved in all sessions of a plan, and what it works against.
struct Motion {
  enum class Form {
    sine,
    constant_speed,  ///< a triangle with rounded corners
  };
  Form form = Form::sine;
  double load_phase_deg = 0;        ///< of the load before the position
  double load_frequency_ratio = 1;  ///< frequency of the load over that of the motion
  double pose_sway_deg = 0;         ///< amplitude of the bend angle about the pose
  double pose_sway_Hz = 0.1;
  double session_interval_h = 1;  ///< from the beginning of one session to that of the next
};

/// Position, velocity, bend angle and output tension at a time; a session begins at the lower end
/// of the stroke, at rest and about to pull. `covariates` is the one before and keeps the rest.
void move_to(double time_s, const Motion& motion, const Setting& setting, Covariates& covariates);

}  // namespace host_sim::synth
