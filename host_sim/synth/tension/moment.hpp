#pragma once

#include <cstddef>
#include <cstdint>

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
struct Moment {
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

}  // namespace host_sim::synth
