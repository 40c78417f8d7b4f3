#pragma once

#include <memory>
#include <span>

#include "host_sim/synth/tension/part.hpp"

namespace host_sim::synth {

using Parts = std::span<const std::unique_ptr<TensionPart>>;

/// Tension at the drive's end of the sheath at full slip or less: the capstan equation
/// dT/dphi = mu T z along the angle, solved exactly where mu does not depend on the tension, else
/// by exponential midpoint steps; never below 0.
/// @param mu before the parts
/// @param friction_state z, -1 .. 1
double tension_at_drive_N(Parts parts, const Moment& moment, double mu, double friction_state);

/// The contact of tendon and sheath, with what it remembers.
class Contact {
 public:
  /// What the contact does in one step: the tendon at the spool moves as `moment` says, a part of
  /// it stretches the tendon, the rest slides. Sets moment.slide_m_s.
  /// @return the tension at the drive's end
  double step(Parts parts, double mu, Moment& moment);

  [[nodiscard]] double friction_state() const { return state_; }

 private:
  double state_ = -1;
  double tension_N_ = 0;
};

}  // namespace host_sim::synth
