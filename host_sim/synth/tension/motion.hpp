#pragma once

#include <string>

#include "host_sim/synth/tension/moment.hpp"

namespace host_sim::synth {

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
/// of the stroke, at rest and about to pull. `moment` is the one before and keeps the rest.
void move_to(double time_s, const Motion& motion, const Setting& setting, Moment& moment);

}  // namespace host_sim::synth
